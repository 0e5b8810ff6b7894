#pragma once

#include <string>
#include <vector>

/// Pages that need no other file: reports that can be mailed, and opened without a network.
namespace cps {

/// A whole HTML page with this title (text) and body (markup). Its style is that of all our pages: readable
/// on a phone, dark where the reader's system is, the diagrams of files/plot.h too. `style`: CSS rules of
/// this page alone.
std::string html_page(const std::string& title, const std::string& body, const std::string& style = "");

/// A table that scrolls sideways where it is wider than the page. Header and cells are markup; every row has
/// as many cells as the header, which is left out if all its texts are empty. Without rows: nothing.
std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows);

}  // namespace cps
