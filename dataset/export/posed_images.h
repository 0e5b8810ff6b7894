#pragma once

#include <map>
#include <string>
#include <vector>

#include "dataset/export/targets.h"
#include "distortion/calibrated_camera.h"

/// For formats of one still scene seen from many poses: each condition of a dataset is one.
namespace cps {

/// The images of every condition, in the order of the split lists. Only where the source has frames.
std::map<std::int64_t, std::vector<const DatasetImage*>> images_by_condition(const ExportSource& source);

/// `condition_000`: the folder of a condition.
std::string condition_folder(std::int64_t condition);

/// Links or copies them to `images/`, below the condition's folder, under the names they have in the dataset.
void add_condition_images(const ExportJob& job, const std::string& folder,
                          const std::vector<const DatasetImage*>& images);

/// The camera of an image's label.
CalibratedCamera calibrated_camera(const Label& label, const std::string& name);

}  // namespace cps
