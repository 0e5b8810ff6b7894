#pragma once

#include "sampler/lenses/real_lens_prior.h"

namespace cps {

/// Printed by fit_real_lenses from the Lensfun database (CC BY-SA 3.0); not to be edited.
// clang-format off
inline constexpr RealLensFit real_lens_numbers[] = {
    {.hfov_deg = 10, .corner = {-0.0377, -0.0130, 0.0043, 0.0182, 0.0339, 0.0458, 0.0941}, .k2_slope = -1.995, .k2_sd = 0.0598, .k3_slope = 1.057, .k3_on_k2 = -0.561, .k3_sd = 0.0038},
    {.hfov_deg = 20, .corner = {-0.0359, -0.0192, -0.0027, 0.0097, 0.0232, 0.0464, 0.0831}, .k2_slope = -1.670, .k2_sd = 0.0464, .k3_slope = 0.967, .k3_on_k2 = -0.550, .k3_sd = 0.0029},
    {.hfov_deg = 30, .corner = {-0.0589, -0.0320, -0.0115, 0.0019, 0.0182, 0.0542, 0.0829}, .k2_slope = -1.439, .k2_sd = 0.0456, .k3_slope = 0.838, .k3_on_k2 = -0.541, .k3_sd = 0.0035},
    {.hfov_deg = 40, .corner = {-0.0800, -0.0565, -0.0243, -0.0095, 0.0087, 0.0533, 0.0940}, .k2_slope = -1.192, .k2_sd = 0.0530, .k3_slope = 0.675, .k3_on_k2 = -0.553, .k3_sd = 0.0061},
    {.hfov_deg = 50, .corner = {-0.1446, -0.0920, -0.0431, -0.0218, -0.0000, 0.0354, 0.0621}, .k2_slope = -1.310, .k2_sd = 0.0760, .k3_slope = 0.568, .k3_on_k2 = -0.564, .k3_sd = 0.0110},
    {.hfov_deg = 60, .corner = {-0.2062, -0.1613, -0.0658, -0.0315, -0.0038, 0.0322, 0.0510}, .k2_slope = -1.090, .k2_sd = 0.0942, .k3_slope = 0.369, .k3_on_k2 = -0.578, .k3_sd = 0.0134},
    {.hfov_deg = 70, .corner = {-0.2606, -0.1855, -0.0641, -0.0331, -0.0044, 0.0242, 0.0474}, .k2_slope = -0.852, .k2_sd = 0.1335, .k3_slope = 0.161, .k3_on_k2 = -0.585, .k3_sd = 0.0180},
    {.hfov_deg = 80, .corner = {-0.1832, -0.1060, -0.0248, -0.0122, 0.0021, 0.0235, 0.0319}, .k2_slope = -1.753, .k2_sd = 0.1134, .k3_slope = 0.621, .k3_on_k2 = -0.523, .k3_sd = 0.0171},
    {.hfov_deg = 90, .corner = {-0.1091, -0.0866, -0.0420, -0.0258, -0.0105, 0.0165, 0.0327}, .k2_slope = -2.013, .k2_sd = 0.1624, .k3_slope = 0.834, .k3_on_k2 = -0.519, .k3_sd = 0.0182},
    {.hfov_deg = 100, .corner = {-0.1049, -0.0839, -0.0524, -0.0299, -0.0166, 0.0207, 0.0447}, .k2_slope = -0.145, .k2_sd = 0.1999, .k3_slope = -0.105, .k3_on_k2 = -0.544, .k3_sd = 0.0215},
};
// clang-format on

}  // namespace cps
