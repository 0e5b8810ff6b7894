#pragma once

#include <string>
#include <vector>

#include "apps/manual/pages.h"

/// The verbs of `cps`, one file each. Each takes the arguments after the verb and returns the exit status: 0,
/// or 1 if a check (verify, lens check) found something wrong. Throws boost::program_options::error for wrong
/// usage (exit 2) and std::runtime_error, one line, for a failure (exit 1).
namespace cps {

using Arguments = std::vector<std::string>;

extern const Manual city_manual, render_manual, plan_manual, generate_manual, finish_manual, verify_manual,
    contact_sheet_manual, export_manual, report_manual, migrate_manual, distort_manual, undistort_manual,
    relens_manual;
const Manual& lens_manual();  // made when it is first asked for, from those of its verbs

int cps_city(const Arguments& arguments);
int cps_render(const Arguments& arguments);
int cps_plan(const Arguments& arguments);
int cps_generate(const Arguments& arguments);
int cps_finish(const Arguments& arguments);
int cps_verify(const Arguments& arguments);
int cps_contact_sheet(const Arguments& arguments);
int cps_export(const Arguments& arguments);
int cps_report(const Arguments& arguments);
int cps_migrate(const Arguments& arguments);
int cps_lens(const Arguments& arguments);
int cps_distort(const Arguments& arguments);
int cps_undistort(const Arguments& arguments);
int cps_relens(const Arguments& arguments);

/// train, eval and predict: replaces this process by cps-train, found beside this program, with the verb and
/// its arguments.
int run_cps_train(const std::string& verb, const Arguments& arguments);

}  // namespace cps
