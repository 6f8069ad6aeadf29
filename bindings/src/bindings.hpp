// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

void bind_low_level(nanobind::module_& m);
void bind_frames(nanobind::module_& m);
void bind_robot(nanobind::module_& m);
void bind_types(nanobind::module_& m);
void bind_task(nanobind::module_& m);
void bind_planner(nanobind::module_& m);
void bind_whole_body(nanobind::module_& m);
void bind_link(nanobind::module_& m);
void bind_walk(nanobind::module_& m);
void bind_run(nanobind::module_& m);
void bind_run_log(nanobind::module_& m);
void bind_estimator(nanobind::module_& m);
void bind_controller(nanobind::module_& m);
void bind_dds_network(nanobind::module_& m);
void bind_dds_link(nanobind::module_& m);
void bind_dds_robot_port(nanobind::module_& m);
void bind_dds_service(nanobind::module_& m);
void bind_stand(nanobind::module_& m);
void bind_safety(nanobind::module_& m);
void bind_supervisor(nanobind::module_& m);
