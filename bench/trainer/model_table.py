#!/usr/bin/python3
"""Networks side by side, from what cps train and cps eval left in their folders; ladder.sh, ablation.sh and deepcalib.sh run it:
    bench/trainer/model_table.py --out NAME --title TITLE --set "test part=eval.json" [--set KITTI=eval_kitti.json ...] MODEL ...
Writes NAME.md and NAME.json. --set names a table of errors and the file of each model folder that has them; the first file's
robustness table, if cps eval --robustness made one, becomes two more tables. A folder without the first file is named as not
measured. Brackets hold 95 % intervals where cps eval has them. CPU minutes are those that rows.sh wrote to cpu_seconds.
--rays gives errors in ray space, which networks and pictures of all lens families have, each beside that of the network's
training mean, and those of each camera where a file has several."""
import argparse
import json
from pathlib import Path

# Key in JSON, heading, and where it is in an evaluation: a number, or value, low and high.
ERRORS = (("hfov_mean_deg", "H-FOV error, °", ("intervals_95", "hfov_mean_deg")),
          ("hfov_ratio", "of the train mean's", ("intervals_95", "hfov_ratio")),
          ("k1_mae_raw", "k1 error, raw", ("network", "raw", "mae", "k1")),
          ("k1_mae_apparent", "apparent", ("network", "apparent", "mae", "k1")),
          ("k1_r2", "R² of apparent k1", ("intervals_95", "k1_r2")),
          ("reprojection_mean_px", "reprojection, px", ("intervals_95", "reprojection_mean_px")),
          ("angle_mean_deg", "angle of rays, °", ("rays", "intervals_95", "angle_mean_deg")))
NOTE = """Errors are means over images, with 95 % intervals over places (pictures for KITTI) in brackets. They may be compared down a
column: the H-FOV is the same in both target spaces, and k1 is stated in both, whatever a network was trained on. Outputs that
a network does not learn stay at its training mean. Losses may not be compared down a column where networks learn different
outputs or were trained on different data: each is in units of its own training set."""

# Key in JSON, heading, and key of the number of images without it: in an evaluation's `rays`.
RAY_ERRORS = (("seen_hfov_mean_deg", "seen H-FOV error, °", "without_seen_hfov"),
              ("angle_mean_deg", "angle of rays, °", "without_angles"),
              ("turned_mean_deg", "after the best turn, °", "without_angles"),
              ("reprojection_mean_px", "reprojection, px", "without_reprojection"),
              ("reprojection_median_px", "its median, px", "without_reprojection"))
LEFT_OUT = ("without_angles", "without_reprojection", "without_seen_hfov")
RAY_NOTE = """Errors are means over images, and a median, with 95 % intervals over places (pictures for KITTI) in brackets. Each stands
beside its *constant*: the error of always answering the network's training mean, which has seen no picture and depends on the
training set. *Left out* counts the images without angles (the predicted lens is not one-to-one on its frame), without
reprojection error (a true ray that the predicted camera cannot show) and without a seen H-FOV. Means over different images are
not comparable, so look at these counts first. A Brown–Conrady lens sends rays near 90° off its axis far away: where pictures
show some, compare medians of the reprojection. Losses of networks that learn different outputs are not comparable either."""


def find(evaluation, path):
    for key in path:
        if not isinstance(evaluation, dict) or key not in evaluation:
            return None
        evaluation = evaluation[key]
    return evaluation


def errors_of(evaluation):
    """What ERRORS lists and the evaluation has, each with value, low and high, which are None where there is no interval."""
    errors = {"images": len(evaluation["images"])}
    for key, _, path in ERRORS:
        found = find(evaluation, path)
        if not isinstance(found, dict):
            found = {"value": found}
        if found.get("value") is not None:
            errors[key] = {bound: found.get(bound) for bound in ("value", "low", "high")}
    return errors


def ray_errors_of(rays):
    """What RAY_ERRORS lists, as errors_of(), with `constant`: that of the training mean. A mean over no images is left out."""
    network, mean = rays["network"], rays["training_mean"]
    errors = {"images": network["images"], "left_out": {key: network[key] for key in LEFT_OUT}}
    for key, _, without in RAY_ERRORS:
        if network[without] < network["images"]:
            errors[key] = {**rays["intervals_95"][key],
                           "constant": mean[key] if mean[without] < mean["images"] else None}
    cameras = {row["camera"]: ray_errors_of(row) for row in rays.get("by_camera", [])}
    return {**errors, "by_camera": cameras} if cameras else errors


def training_of(folder):
    model = json.loads((folder / "model.json").read_text())
    seconds = folder / "cpu_seconds"
    is_deepcalib = model["options"].get("head", "").startswith("deepcalib")
    return {"dataset": Path(model["dataset"]["folder"]).name,
            "outputs": model["outputs"]["names"] if is_deepcalib else model["options"]["outputs"],
            "images": model["dataset"]["training_images"],
            "epochs": len((folder / "history.csv").read_text().splitlines()) - 1,
            "best_epoch": model["epoch"],
            "validation_loss": model["validation_loss"],
            "cpu_minutes": sum(float(word) for word in seconds.read_text().split()) / 60 if seconds.exists() else None}


def network_of(folder, sets, rays):
    evaluations = {name: json.loads((folder / file).read_text()) for name, file in sets.items() if (folder / file).exists()}
    first = evaluations[next(iter(sets))]
    return {"name": folder.name, "training": training_of(folder),
            "sets": {name: ray_errors_of(evaluation["rays"]) if rays else errors_of(evaluation)
                     for name, evaluation in evaluations.items()},
            "robustness": {row["name"]: {key: row[key] for key in row if key != "name"} for row in first.get("robustness", [])}}


def number(value):
    if value is None:
        return "–"
    text = f"{value:.3g}"
    return f"{value:.0f}" if "e+" in text and abs(value) < 1e6 else text


def estimate(error):
    if error is None:
        return "–"
    if error["low"] is None or error["high"] is None:
        return number(error["value"])
    return f"{number(error['value'])} [{number(error['low'])}, {number(error['high'])}]"


def table(headings, rows):
    lines = [headings, ["---"] * len(headings), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def training_table(networks):
    rows = []
    for network in networks:
        t = network["training"]
        outputs = "all" if len(t["outputs"]) == 8 else " ".join(t["outputs"])
        rows.append([network["name"], t["dataset"], outputs, str(t["images"]), f"{t['epochs']} ({t['best_epoch']})",
                     number(t["cpu_minutes"]), number(t["validation_loss"])])
    return table(["network", "data", "learns", "images", "epochs (best)", "CPU min", "validation loss"], rows)


def error_table(networks, name):
    rows = [[network["name"], str(errors["images"]), *(estimate(errors.get(key)) for key, _, _ in ERRORS)]
            for network in networks if (errors := network["sets"].get(name))]
    return table(["network", "images", *(heading for _, heading, _ in ERRORS)], rows)


def ray_cells(errors):
    cells = [str(errors["images"]), ", ".join(str(errors["left_out"][key]) for key in LEFT_OUT)]
    for key, _, _ in RAY_ERRORS:
        error = errors.get(key)
        cells += [estimate(error), number(error["constant"]) if error else "–"]
    return cells


RAY_HEADINGS = ["images", "left out", *(heading for _, name, _ in RAY_ERRORS for heading in (name, "constant"))]


def ray_tables(networks, name):
    """With their headings: the errors in a set, and those of its cameras."""
    measured = [(network["name"], errors) for network in networks if (errors := network["sets"].get(name))]
    parts = [f"## Errors: {name}\n", table(["network", *RAY_HEADINGS], [[model, *ray_cells(errors)] for model, errors in measured])]
    cameras = [[model, camera, *ray_cells(of_camera)]
               for model, errors in measured for camera, of_camera in errors.get("by_camera", {}).items()]
    if cameras:
        parts += [f"## Errors by camera: {name}\n", table(["network", "camera", *RAY_HEADINGS], cameras)]
    return parts


def robustness_table(networks, key):
    measured = [network for network in networks if network["robustness"]]
    corruptions = list(dict.fromkeys(name for network in measured for name in network["robustness"]))
    return table(["network", *corruptions],
                 [[network["name"], *(number(network["robustness"].get(name, {}).get(key)) for name in corruptions)]
                  for network in measured])


def page(title, networks, sets, missing, rays):
    parts = [f"# {title}\n", (RAY_NOTE if rays else NOTE) + "\n", "## Training\n", training_table(networks)]
    for name in sets:
        if any(name in network["sets"] for network in networks):
            parts += ray_tables(networks, name) if rays else [f"## Errors: {name}\n", error_table(networks, name)]
    if any(network["robustness"] for network in networks):
        first = next(iter(sets))
        parts += [f"## Loss under corruption: {first}\n", robustness_table(networks, "loss"),
                  f"## H-FOV error under corruption, °: {first}\n", robustness_table(networks, "hfov_mean_deg")]
    if missing:
        parts.append(f"Not measured: {', '.join(missing)}.\n")
    return "\n".join(parts)


def write(file, text):
    """By rename, so that an interruption leaves the file before."""
    partial = file.with_name(file.name + ".partial")
    partial.write_text(text)
    partial.replace(file)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, metavar="NAME")
    parser.add_argument("--title", required=True)
    parser.add_argument("--set", action="append", required=True, metavar="NAME=FILE", dest="sets")
    parser.add_argument("--rays", action="store_true", help="errors in ray space, for networks of several lens families")
    parser.add_argument("models", nargs="+", type=Path, metavar="MODEL")
    options = parser.parse_args(arguments)
    sets = dict(text.rsplit("=", 1) for text in options.sets)
    first = next(iter(sets.values()))
    measured = [folder for folder in options.models if (folder / first).exists()]
    missing = [folder.name for folder in options.models if folder not in measured]
    networks = [network_of(folder, sets, options.rays) for folder in measured]
    result = {"title": options.title, "sets": list(sets), "networks": networks, "not_measured": missing}
    write(options.out.with_name(options.out.name + ".json"), json.dumps(result, indent=2, ensure_ascii=False) + "\n")
    write(options.out.with_name(options.out.name + ".md"), page(options.title, networks, sets, missing, options.rays))


if __name__ == "__main__":
    main()
