#pragma once

#include <string>

namespace cps {

/// A calibration.json of schema 1, to the byte as a program wrote it that knew no other: the group
/// 480x270_hfov090/front_lens0026 of a dataset of the recipe demo.
inline const std::string old_label = R"({
  "schema": 1,
  "fov": 64.6770863871766,
  "K": [
    [
      379.07762748784705,
      0.0,
      253.65656501473816
    ],
    [
      0.0,
      379.07762748784705,
      139.67174800648638
    ],
    [
      0.0,
      0.0,
      1.0
    ]
  ],
  "width": 480,
  "height": 270,
  "k1": -0.48237934985647657,
  "k2": 0.13262831992762547,
  "k3": 0.04988994805764247,
  "p1": 0.007539121968883318,
  "p2": 0.006419086187385596,
  "cx": 253.65656501473816,
  "cy": 139.67174800648638,
  "fov_base_deg": 90.0,
  "fov_true_deg": {
    "h": 81.3141982756049,
    "v": 41.8559520307693,
    "d": 92.15394009825746
  },
  "crop": {
    "zoom": 1.5794901145326958
  },
  "certificate": {
    "min_eigenvalue": 0.38217424935228134,
    "max_roundtrip_px": 1.4210854715202004e-13
  },
  "limits": {
    "k1": null,
    "k2": null,
    "k3": null,
    "p1": null,
    "p2": null,
    "cx": [
      225.1,
      253.9
    ],
    "cy": [
      112.9,
      156.1
    ]
  },
  "camera": {
    "name": "front",
    "T_vehicle_camera": [
      [
        0.0,
        0.0,
        1.0,
        1.68
      ],
      [
        -1.0,
        0.0,
        0.0,
        0.0
      ],
      [
        0.0,
        -1.0,
        0.0,
        1.65
      ],
      [
        0.0,
        0.0,
        0.0,
        1.0
      ]
    ]
  },
  "part": "test",
  "seed": 1,
  "generator": "cps 0.1.0"
}
)";

}  // namespace cps
