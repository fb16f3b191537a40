# SPDX-License-Identifier: MIT
"""Renders a Steradian project with Blender's Cycles, as a yardstick: planes, spheres, meshes, point and rectangle lights, a
sky of one colour.

    blender -b --factory-startup -P cycles_scene.py -- SCENE.srad -o OUT.exr --spp 64 [--bounces 32] [--size 256x256]

The geometry is exact: quads of 200 m stand for the infinite planes, and each sphere is a point of a point cloud, which Cycles
intersects analytically. Prints one JSON line: samples, seconds (Cycles' own render time, without scene sync), wall seconds.
"""

import argparse
import array
import json
import math
import os
import re
import struct
import sys
import time

import bpy
from mathutils import Matrix, Quaternion, Vector

# Measured: over a white Lambert plane E / pi with E = I cos(theta) / d^2 comes out to 5 digits when P = 4 pi I.
WATTS_PER_CANDELA = 4.0 * math.pi
# 1 - F(wo.h), Schlick with F0 = 0.04, averaged over cosine-distributed pairs of directions: what is left for the diffuse lobe.
DIFFUSE_SHARE = 0.9565


def transform_of(item):
    x, y, z, w = item.get("rotation", [0, 0, 0, 1])
    return Matrix.LocRotScale(
        Vector(item.get("translation", [0, 0, 0])), Quaternion((w, x, y, z)), Vector(item.get("scale", [1, 1, 1]))
    )


def principled(record):
    """Principled BSDF; Cycles and glTF share alpha = roughness^2, and specular 0.5 means F0 = 0.04."""
    material = bpy.data.materials.new(record["name"])
    material.use_nodes = True
    node = material.node_tree.nodes["Principled BSDF"]
    node.distribution = "GGX"
    node.inputs["Base Color"].default_value = (*record.get("albedo", [0.8] * 3), 1.0)
    node.inputs["Metallic"].default_value = record.get("metallic", 0.0)
    node.inputs["Roughness"].default_value = record.get("roughness", 0.5)
    node.inputs["Specular"].default_value = 0.5 * record.get("specular", 1.0)
    return material


def layered(record):
    """Principled's specular lobe over Lambert: nearer to glTF's sum than Principled alone, whose diffuse lobe is Burley's
    and is not dimmed by what the specular lobe reflects."""
    if record.get("metallic", 0.0) > 0.0:
        return principled(record)
    material = principled({**record, "albedo": [0.0, 0.0, 0.0]})
    tree = material.node_tree
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    share = 1.0 - (1.0 - DIFFUSE_SHARE) * record.get("specular", 1.0)
    dimmed = [share * value for value in record.get("albedo", [0.8] * 3)]
    diffuse.inputs["Color"].default_value = (*dimmed, 1.0)
    if record.get("specular", 1.0) == 0.0:  # Principled would still reflect at grazing angles
        tree.links.new(diffuse.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
        return material
    add = tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(tree.nodes["Principled BSDF"].outputs[0], add.inputs[0])
    tree.links.new(diffuse.outputs[0], add.inputs[1])
    tree.links.new(add.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material


def add_mesh(name, vertices, faces, world, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(material)
    item = bpy.data.objects.new(name, mesh)
    item.matrix_world = world
    bpy.context.scene.collection.objects.link(item)
    return item


def add_plane(name, world, material):
    h = 100.0
    add_mesh(name, [(-h, 0, h), (h, 0, h), (h, 0, -h), (-h, 0, -h)], [(0, 1, 2, 3)], world, material)


def add_sphere(name, radius, world, material):
    """One vertex, turned by geometry nodes into a one-point cloud."""
    item = add_mesh(name, [(0, 0, 0)], [], world, material)
    tree = bpy.data.node_groups.new(name, "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    points = tree.nodes.new("GeometryNodeMeshToPoints")
    points.inputs["Radius"].default_value = radius
    paint = tree.nodes.new("GeometryNodeSetMaterial")
    paint.inputs["Material"].default_value = material
    source, sink = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    tree.links.new(source.outputs[0], points.inputs["Mesh"])
    tree.links.new(points.outputs[0], paint.inputs["Geometry"])
    tree.links.new(paint.outputs[0], sink.inputs[0])
    item.modifiers.new("points", "NODES").node_group = tree


def add_point_light(name, record, world):
    light = bpy.data.lights.new(name, "POINT")
    light.color = record.get("color", [1, 1, 1])
    light.energy = WATTS_PER_CANDELA * record.get("intensity", 10.0)
    light.shadow_soft_size = 0.0
    item = bpy.data.objects.new(name, light)
    item.matrix_world = world
    bpy.context.scene.collection.objects.link(item)


def add_rect_light(name, record, world):
    """Measured: over a white Lambert plane radiance comes out to 3 digits as watts / (4 * area)."""
    light = bpy.data.lights.new(name, "AREA")
    light.shape = "RECTANGLE"
    light.size, light.size_y = record.get("size", [1.0, 1.0])
    light.color = record.get("color", [1, 1, 1])
    light.energy = 4.0 * light.size * light.size_y * record.get("intensity", 10.0)
    item = bpy.data.objects.new(name, light)
    item.matrix_world = world
    bpy.context.scene.collection.objects.link(item)


def set_sky(record):
    world = bpy.context.scene.world
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*record.get("color", [1, 1, 1]), 1.0)
    background.inputs["Strength"].default_value = record.get("intensity", 1.0)


def add_triangles(name, path, world, material):
    """A `.mesh` file of the project format: header, positions, vertex indices; without its other attributes."""
    with open(path, "rb") as file:
        magic, version, attributes, vertices, triangles = struct.unpack("<8sIIQQ", file.read(32))
        if magic != b"SRADMESH" or version != 1:
            sys.exit(f"{path}: not a mesh of version 1")
        positions, corners = array.array("f"), array.array("i")
        positions.fromfile(file, 3 * vertices)
        corners.fromfile(file, 3 * triangles)
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(vertices)
    mesh.vertices.foreach_set("co", positions)
    mesh.loops.add(3 * triangles)
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(triangles)
    mesh.polygons.foreach_set("loop_start", range(0, 3 * triangles, 3))
    mesh.polygons.foreach_set("loop_total", [3] * triangles)
    mesh.polygons.foreach_set("use_smooth", [bool(attributes & 1)] * triangles)
    mesh.materials.append(material)
    mesh.update(calc_edges=True)
    item = bpy.data.objects.new(name, mesh)
    item.matrix_world = world
    bpy.context.scene.collection.objects.link(item)


def add_camera(name, record, world):
    camera = bpy.data.cameras.new(name)
    camera.sensor_fit = "VERTICAL"
    camera.angle = record.get("fovY", 0.7853982)
    camera.clip_start = 1e-3
    item = bpy.data.objects.new(name, camera)
    item.matrix_world = world
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item


def build(project, folder, make_material):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.world = bpy.data.worlds.new("black")
    bpy.context.scene.world.color = (0.0, 0.0, 0.0)
    materials = {record["id"]: make_material(record) for record in project["materials"]}
    assets = {record["id"]: os.path.join(folder, record["asset"]) for record in project.get("meshes", [])}
    for item in project["objects"]:
        world, name, material = transform_of(item), item["name"], materials.get(item.get("material"))
        if "plane" in item:
            add_plane(name, world, material)
        elif "sphere" in item:
            add_sphere(name, item["sphere"].get("radius", 1.0), world, material)
        elif "pointLight" in item:
            add_point_light(name, item["pointLight"], world)
        elif "mesh" in item:
            add_triangles(name, assets[item["mesh"]["id"]], world, material)
        elif "rectLight" in item:
            add_rect_light(name, item["rectLight"], world)
        elif "environmentLight" in item:
            set_sky(item["environmentLight"])
        elif "camera" in item:
            add_camera(name, item["camera"], world)
        else:
            sys.exit(f"{name}: this kind of object is not translated")


def configure(width, height, bounces, threads):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.light_sampling_threshold = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    cycles.use_auto_tile = False


def cycles_seconds(path):
    """Cycles' own render time, from the metadata that it writes into the EXR ("hh:mm:ss.cc")."""
    with open(path, "rb") as file:
        header = file.read(65536)
    match = re.search(rb"cycles\.[^\0]*\.render_time\0string\0....([0-9:.]+)", header, re.DOTALL)
    if not match:
        return None
    seconds = 0.0
    for part in match.group(1).decode().split(":"):
        seconds = seconds * 60.0 + float(part)
    return seconds


def render(path, spp, seed):
    scene = bpy.context.scene
    scene.cycles.samples = spp
    scene.cycles.seed = seed
    scene.render.filepath = path
    start = time.monotonic()
    bpy.ops.render.render(write_still=True)
    wall = time.monotonic() - start
    return {"samples": spp, "seconds": cycles_seconds(path) or wall, "wallSeconds": wall, "image": path}


def main():
    parser = argparse.ArgumentParser(prog="cycles_scene.py")
    parser.add_argument("project")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--bounces", type=int, default=32)
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--materials", choices=["principled", "layered"], default="layered")
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    with open(arguments.project, encoding="utf-8") as file:
        project = json.load(file)
    build(project, os.path.dirname(arguments.project), {"principled": principled, "layered": layered}[arguments.materials])
    width, height = map(int, arguments.size.split("x"))
    configure(width, height, arguments.bounces, arguments.threads)
    print(json.dumps(render(arguments.output, arguments.spp, arguments.seed)))


if __name__ == "__main__":
    main()
