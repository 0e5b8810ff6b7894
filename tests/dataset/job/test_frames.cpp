#include <catch2/catch.hpp>
#include <cmath>

#include "dataset/job/frames.h"
#include "files/files.h"
#include "tests/dataset/edit_csv.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

/// Three unit vectors: forward, left, up.
struct Axes {
  Eigen::Vector3d forward, left, up;
};

/// Turned to the left, then the nose up, then the right side down; in plain trigonometry.
Axes turned(const Axes& from, double left_deg, double up_deg, double clockwise_deg) {
  const auto cosine = [](double deg) { return std::cos(deg * M_PI / 180); };
  const auto sine = [](double deg) { return std::sin(deg * M_PI / 180); };
  Axes to = from;
  to.forward = cosine(left_deg) * from.forward + sine(left_deg) * from.left;
  to.left = cosine(left_deg) * from.left - sine(left_deg) * from.forward;
  const Axes level = to;
  to.forward = cosine(up_deg) * level.forward + sine(up_deg) * level.up;
  to.up = cosine(up_deg) * level.up - sine(up_deg) * level.forward;
  const Axes nose_up = to;
  to.left = cosine(clockwise_deg) * nose_up.left + sine(clockwise_deg) * nose_up.up;
  to.up = cosine(clockwise_deg) * nose_up.up - sine(clockwise_deg) * nose_up.left;
  return to;
}

/// The columns of a unit quaternion's rotation matrix, by its formula.
std::array<Eigen::Vector3d, 3> rotation_columns(double w, double x, double y, double z) {
  return {Eigen::Vector3d(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
          Eigen::Vector3d(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
          Eigen::Vector3d(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))};
}

PlannedView turned_view() {
  PlannedView view;
  view.street = "Main St,\n\"old\"";
  view.part = Part::val;
  view.condition = 3;
  view.place = {.position = {312.25, -1.75, 87.5},
                .heading_rad = 130 * M_PI / 180,
                .pitch_rad = 4 * M_PI / 180,
                .roll_rad = -3 * M_PI / 180};
  view.camera = {
      .name = "side", .position_m = {1.2, 0.7, 1.5}, .yaw_deg = 75, .pitch_deg = -8, .roll_deg = 11};
  return view;
}

const ViewRecord record{.view = 0, .exposure = 0.1 + 0.2, .images = {}};
const ImageRecord image{.file = "set/leaf/000002.png",
                        .sensor = {.exposure_bias_ev = -0.3, .full_well_e = 1e4 / 3, .read_noise_e = 2.5},
                        .sha256 = "ab",
                        .pixels_sha256 = "cd"};

}  // namespace

TEST_CASE("every column of frames.csv holds the quantity that its name says") {
  const PlannedView view = turned_view();
  const CsvTable table = parse_csv(frames_csv({{&view, &record, &image}}), "frames.csv");
  const std::vector<std::string> names = {"file",
                                          "part",
                                          "condition",
                                          "street",
                                          "vehicle_x_m",
                                          "vehicle_y_m",
                                          "vehicle_z_m",
                                          "vehicle_heading_deg",
                                          "vehicle_pitch_deg",
                                          "vehicle_roll_deg",
                                          "camera_x_m",
                                          "camera_y_m",
                                          "camera_z_m",
                                          "camera_qw",
                                          "camera_qx",
                                          "camera_qy",
                                          "camera_qz",
                                          "gravity_x",
                                          "gravity_y",
                                          "gravity_z",
                                          "exposure",
                                          "exposure_bias_ev",
                                          "full_well_e",
                                          "read_noise_e",
                                          "sha256"};
  CHECK(table.header == names);
  REQUIRE(table.rows.size() == 1);
  const auto text = [&](const char* name) { return table.at(0, table.column(name)).text(); };
  const auto number = [&](const char* name) { return std::stod(text(name)); };
  CHECK(text("file") == "000002.png");
  CHECK(text("part") == "val");
  CHECK(text("condition") == "3");
  CHECK(text("street") == "Main St,\n\"old\"");
  CHECK(text("sha256") == "ab");
  // Numbers read back to the same bits.
  CHECK(number("exposure") == 0.1 + 0.2);
  CHECK(number("exposure_bias_ev") == -0.3);
  CHECK(number("full_well_e") == 1e4 / 3);
  CHECK(number("read_noise_e") == 2.5);
  CHECK(number("vehicle_x_m") == 312.25);
  CHECK(number("vehicle_y_m") == -1.75);
  CHECK(number("vehicle_z_m") == 87.5);
  CHECK(number("vehicle_heading_deg") == Approx(130).epsilon(1e-14));
  CHECK(number("vehicle_pitch_deg") == Approx(4).epsilon(1e-14));
  CHECK(number("vehicle_roll_deg") == Approx(-3).epsilon(1e-14));

  // World: y up, heading 0 along +x, growing to the left, which is −z there.
  const Axes east{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, car = turned(east, 130, 4, -3);
  const Eigen::Vector3d position =
      Eigen::Vector3d(312.25, -1.75, 87.5) + 1.2 * car.forward + 0.7 * car.left + 1.5 * car.up;
  CHECK(number("camera_x_m") == Approx(position.x()).epsilon(1e-13));
  CHECK(number("camera_y_m") == Approx(position.y()).epsilon(1e-13));
  CHECK(number("camera_z_m") == Approx(position.z()).epsilon(1e-13));
  const Axes camera = turned(car, 75, -8, 11);
  const auto columns =
      rotation_columns(number("camera_qw"), number("camera_qx"), number("camera_qy"), number("camera_qz"));
  CHECK((columns[0] + camera.left).norm() < 1e-14);  // x right
  CHECK((columns[1] + camera.up).norm() < 1e-14);    // y down
  CHECK((columns[2] - camera.forward).norm() < 1e-14);
  // Downwards, (0, −1, 0), along the camera's axes right, down and forward.
  CHECK(number("gravity_x") == Approx(camera.left.y()).margin(1e-14));
  CHECK(number("gravity_y") == Approx(camera.up.y()).margin(1e-14));
  CHECK(number("gravity_z") == Approx(-camera.forward.y()).margin(1e-14));
}

TEST_CASE("gravity has closed forms: level, nose up, right side down") {
  const auto gravity = [](double heading, double pitch, double roll) {
    PlannedView view;
    view.place = {.heading_rad = heading, .pitch_rad = pitch, .roll_rad = roll};
    return frame_row({&view, &record, &image}).gravity;
  };
  using Vector = Eigen::Vector3d;
  CHECK((gravity(0, 0, 0) - Vector(0, 1, 0)).norm() < 1e-14);
  CHECK((gravity(2.2, 0, 0) - Vector(0, 1, 0)).norm() < 1e-14);
  CHECK((gravity(2.2, .3, 0) - Vector(0, std::cos(.3), -std::sin(.3))).norm() < 1e-14);
  CHECK((gravity(2.2, 0, .4) - Vector(std::sin(.4), std::cos(.4), 0)).norm() < 1e-14);
}

TEST_CASE("the hashes of dense labels are the last columns, for the labels that the dataset has") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "frames.csv";
  const PlannedView view = turned_view();
  ImageRecord labelled = image;
  labelled.dense = {{DenseLabel::distance, 12, "d1"}, {DenseLabel::up, 7, "d2"}};
  CsvTable table = parse_csv(frames_csv({{&view, &record, &labelled}, {&view, &record, &labelled}}), file);
  REQUIRE(table.header.size() == frame_columns().size() + 2);
  CHECK(table.header[frame_columns().size()] == "distance_sha256");
  CHECK(table.header.back() == "up_sha256");
  for (bool is_reversed : {false, true}) {
    if (is_reversed)
      for (auto* row : {&table.header, &table.rows[0], &table.rows[1]})
        std::reverse(row->begin(), row->end());
    write_csv(table);
    const std::vector<FrameRow> rows = read_frames_csv(file);
    REQUIRE(rows.size() == 2);
    for (const FrameRow& row : rows) {
      REQUIRE(row.dense.size() == 2);
      CHECK((row.dense[0].label == DenseLabel::distance && row.dense[0].sha256 == "d1"));
      CHECK((row.dense[1].label == DenseLabel::up && row.dense[1].sha256 == "d2"));
    }
  }
  CHECK(parse_csv(frames_csv({{&view, &record, &image}}), file).header.back() == "sha256");
  CHECK(parse_csv(frames_csv({}), file).header.size() == frame_columns().size());
}

TEST_CASE("a frames.csv of schema 1 reads, with the gravity of its poses") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "frames.csv";
  write_file(
      file,
      std::string(
          R"(file,part,condition,street,vehicle_x_m,vehicle_y_m,vehicle_z_m,vehicle_heading_deg,vehicle_pitch_deg,vehicle_roll_deg,camera_x_m,camera_y_m,camera_z_m,camera_qw,camera_qx,camera_qy,camera_qz,exposure,exposure_bias_ev,full_well_e,read_noise_e,sha256
000008.png,test,1,4-1,-4.194331997911729,-0.46946785613779846,38.98884828747959,-125.36778995616119,0.6589047586712155,1.42967601759338,-5.1879081203306585,1.1883385510595033,40.32135518287284,0.0015804274529034232,-0.3007545247612979,0.018233332602930405,0.9535259638137091,0.16385174518628315,0.20231130479831905,4986.258646803792,3.2102104074031184,21cec48f074d26455ea45b6c00336bfd9b30e90867ffb47bff322072a6f9d69a
)"));
  const std::vector<FrameRow> rows = read_frames_csv(file);
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].sha256.starts_with("21cec48f"));
  CHECK(rows[0].dense.empty());
  const auto columns =
      rotation_columns(0.0015804274529034232, -0.3007545247612979, 0.018233332602930405, 0.9535259638137091);
  const Eigen::Vector3d expected(-columns[0].y(), -columns[1].y(), -columns[2].y());
  CHECK((rows[0].gravity - expected).norm() < 1e-14);
  CHECK(expected.y() > .99);  // the car is nearly level
}

TEST_CASE("every column of frames.csv reads back, in any order of the columns") {
  const TemporaryFolder folder;
  const PlannedView view = turned_view();
  const std::vector<Frame> frames = {{&view, &record, &image}};
  const FrameRow expected = frame_row(frames[0]);
  CsvTable table = parse_csv(frames_csv(frames), folder.path / "frames.csv");
  for (bool is_reversed : {false, true}) {
    if (is_reversed)
      for (auto* row : {&table.header, &table.rows[0]}) std::reverse(row->begin(), row->end());
    write_csv(table);
    const std::vector<FrameRow> rows = read_frames_csv(folder.path / "frames.csv");
    REQUIRE(rows.size() == 1);
    // What is read is written as it was: no column is lost or read into another's place …
    for (const FrameColumn& column : frame_columns()) {
      INFO(column.name);
      const bool is_angle = std::string(column.name).find("_deg") != std::string::npos;
      if (is_angle)  // degrees → radians → degrees costs the last bit
        CHECK(std::stod(column.write(rows[0])) == Approx(std::stod(column.write(expected))).epsilon(1e-15));
      else
        CHECK(column.write(rows[0]) == column.write(expected));
    }
    // … and is the view's pose.
    CHECK((world_from_vehicle(rows[0].vehicle).matrix() - world_from_vehicle(view.place).matrix()).norm() <
          1e-12);
    const Eigen::Isometry3d camera = world_from_vehicle(view.place) * vehicle_from_camera(view.camera);
    CHECK((world_from_camera(rows[0]).matrix() - camera.matrix()).norm() < 1e-12);
  }
}

TEST_CASE("a frames.csv that is cut short, lacks a column or holds another word is refused") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "frames.csv";
  const PlannedView view = turned_view();
  const CsvTable good = parse_csv(frames_csv({{&view, &record, &image}}), file);
  const auto refusal = [&](const CsvTable& table) {
    write_csv(table);
    try {
      read_frames_csv(file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto with = [&](const char* column, const std::string& text) {
    CsvTable table = good;
    table.rows[0][table.column(column)] = text;
    return refusal(table);
  };
  CHECK(refusal(good) == "accepted");
  const std::string name = file.string();
  CHECK(with("condition", "3 ") == name + ": line 2: condition: '3 ' is not a whole number");
  CHECK(with("condition", "night") == name + ": line 2: condition: 'night' is not a whole number");
  CHECK(with("condition", "-1") == name + ": line 2: condition: must not be negative");
  CHECK(with("part", "all") == name + ": line 2: part: 'all' is none of train, val, test");
  CHECK(with("camera_qy", "") == name + ": line 2: camera_qy: '' is not a number");
  CHECK(with("vehicle_roll_deg", "nan") == name + ": line 2: vehicle_roll_deg: 'nan' is not a number");
  for (const FrameColumn& column : frame_columns()) {
    CsvTable lacking = good;
    const auto c = static_cast<std::ptrdiff_t>(good.column(column.name));
    lacking.header.erase(lacking.header.begin() + c);
    lacking.rows[0].erase(lacking.rows[0].begin() + c);
    CHECK(refusal(lacking) ==
          (column.derive ? "accepted" : name + ": " + column.name + ": column is missing"));
    lacking = good;
    lacking.rows[0].pop_back();
    CHECK_THAT(refusal(lacking), Catch::StartsWith(name + ": line 2: has 24 fields"));
  }
}
