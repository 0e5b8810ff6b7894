#pragma once

#include <string>
#include <vector>

#include "dataset/job/masters.h"
#include "dataset/labels/reader.h"

namespace cps {

/// What all images of one place have in common, and no others of the dataset: `480x270_hfov090/000017`, its
/// set's folder and its number there. All images of a panorama (cps relens --panorama) show one place.
std::string place_of(const Dataset& dataset, const DatasetImage& image);

/// The place of a kept master: place_of() of the images that were made of it.
std::string place_of(const KeptMaster& master);

/// Of the dataset's images with these indices, those of a share of their places, (0, 1], in the same order:
/// as many places as the share says, rounded, and at least one. The places are chosen by a hash of their
/// names, so a smaller share of the same images is a part of a larger one, and images and kept masters of the
/// same places are chosen alike.
std::vector<int> share_of_places(const Dataset& dataset, const std::vector<int>& images, double share);
std::vector<KeptMaster> share_of_places(const std::vector<KeptMaster>& masters, double share);

}  // namespace cps
