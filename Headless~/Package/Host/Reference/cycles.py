"""Draws a scene in Blender's Cycles: blender -b -noaudio --python-exit-code 3 -P cycles.py -- scene.json

scene.json is written by `rill reference` (CyclesScene.cs), with paths of files beside it. All of it is in Unity's axes: x right, y up, z forward,
left-handed. Blender's are right-handed with z up, so y and z change places here and nowhere else. Colors are linear.

No numpy: the Python of Debian's Blender has none unless someone installs it.
"""
import array
import json
import math
import os
import sys

import bpy
from mathutils import Matrix, Vector

SWAP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def swapped(v):
    return Vector((v[0], v[2], v[1]))


def matrix(rows):
    return SWAP @ Matrix([rows[4 * i:4 * i + 4] for i in range(4)]) @ SWAP


def swap_mesh(mesh):
    """A mirrored mesh keeps its outside only where its faces turn the other way."""
    mesh.transform(SWAP)
    mesh.flip_normals()


# meshes


def read_mesh(path, name):
    """int32 vertices, corners, faces; float32 xyz of vertices; int32 vertex of corners; int32 corners of faces."""
    with open(path, 'rb') as file:
        def read(kind, count):
            values = array.array(kind)
            values.fromfile(file, count)
            return values
        vertices, corners, faces = read('i', 3)
        positions, corner_vertex, sizes = read('f', 3 * vertices), read('i', corners), read('i', faces)
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(vertices)
    mesh.vertices.foreach_set('co', positions)
    mesh.loops.add(corners)
    mesh.loops.foreach_set('vertex_index', corner_vertex)
    starts = array.array('i', [0] * faces)
    at = 0
    for i in range(faces):
        starts[i] = at
        at += sizes[i]
    mesh.polygons.add(faces)
    mesh.polygons.foreach_set('loop_start', starts)
    mesh.polygons.foreach_set('loop_total', sizes)
    mesh.update(calc_edges=True)
    swap_mesh(mesh)
    return mesh


def box(name, size):
    x, y, z = (0.5 * s for s in size)
    corners = [(sx * x, sy * y, sz * z) for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    swap_mesh(mesh)
    return mesh


def of_operator(name, operator, **settings):
    operator(**settings)
    mesh = bpy.context.object.data
    bpy.data.objects.remove(bpy.context.object)
    mesh.name = name
    return mesh


def mesh_of(given, folder):
    name, shape = given['name'], given.get('shape')
    if shape is None:
        return read_mesh(os.path.join(folder, given['file']), name)
    if shape == 'sphere':        # 327,680 triangles
        return of_operator(name, bpy.ops.mesh.primitive_ico_sphere_add, subdivisions=8, radius=given['radius'])
    if shape == 'cylinder':      # along Unity's y, which is Blender's z
        return of_operator(name, bpy.ops.mesh.primitive_cylinder_add, vertices=2048, radius=given['radius'], depth=given['length'])
    if shape == 'box':
        return box(name, given['size'])
    raise ValueError(f'unknown shape {shape}')


def smooth(mesh, degrees):
    """Edges that bend less than this are round."""
    mesh.polygons.foreach_set('use_smooth', [True] * len(mesh.polygons))
    mesh.use_auto_smooth = degrees < 180
    mesh.auto_smooth_angle = math.radians(min(degrees, 180))


# materials


class Nodes:
    def __init__(self, tree):
        self.nodes, self.links = tree.nodes, tree.links
        self.nodes.clear()

    def new(self, kind, inputs=None, **settings):
        node = self.nodes.new(kind)
        for key, value in settings.items():
            setattr(node, key, value)
        for key, value in (inputs or {}).items():
            if isinstance(value, bpy.types.NodeSocket):
                self.links.new(value, node.inputs[key])
            else:
                node.inputs[key].default_value = value
        return node

    def math(self, operation, *inputs):
        return self.new('ShaderNodeMath', dict(enumerate(inputs)), operation=operation).outputs[0]

    def board(self, given):
        """Squares of Unity's x and y. The square from (0, 0) to (size, size) has the first color."""
        separated = self.new('ShaderNodeSeparateXYZ', {0: self.new('ShaderNodeNewGeometry').outputs['Position']})
        index = [self.math('FLOOR', self.math('DIVIDE', separated.outputs[axis], given['size'])) for axis in ('X', 'Z')]
        half = self.math('FRACT', self.math('MULTIPLY', self.math('ADD', *index), 0.5))        # 0 or 0.5
        odd = self.math('GREATER_THAN', half, 0.25)
        return self.new('ShaderNodeMixRGB', {0: odd, 1: rgba(given['colors'][0]), 2: rgba(given['colors'][1])}).outputs[0]


    def hash(self, x, y):
        return self.math('FRACT', self.math('MULTIPLY', self.math('SINE', self.math('ADD', self.math('MULTIPLY', x, 12.9898),
                                                                                    self.math('MULTIPLY', y, 78.233))), 43758.5453))

    def grain(self, x, y):
        """Between the hashes of four corners."""
        corner = [self.math('FLOOR', x), self.math('FLOOR', y)]
        within = [self.math('SUBTRACT', x, corner[0]), self.math('SUBTRACT', y, corner[1])]
        smooth = [self.math('MULTIPLY', self.math('MULTIPLY', t, t), self.math('SUBTRACT', 3.0, self.math('MULTIPLY', t, 2.0))) for t in within]
        beyond = [self.math('ADD', c, 1.0) for c in corner]

        def between(a, b, t):
            return self.math('ADD', a, self.math('MULTIPLY', self.math('SUBTRACT', b, a), t))
        return between(between(self.hash(*corner), self.hash(beyond[0], corner[1]), smooth[0]),
                       between(self.hash(corner[0], beyond[1]), self.hash(*beyond), smooth[0]), smooth[1])

    def tiles(self, side):
        """TileShade of Solid.hlsl without its filter: samples do that here. Of Unity's axes, by the largest part of the normal."""
        geometry = self.new('ShaderNodeNewGeometry')
        at = self.new('ShaderNodeSeparateXYZ', {0: geometry.outputs['Position']}).outputs
        facing = [self.math('ABSOLUTE', axis) for axis in self.new('ShaderNodeSeparateXYZ', {0: geometry.outputs['True Normal']}).outputs]
        x, y, z = at[0], at[2], at[1]                   # Unity's
        up = self.math('COMPARE', facing[2], self.math('MAXIMUM', self.math('MAXIMUM', facing[0], facing[1]), facing[2]), 1e-5)
        across = self.math('GREATER_THAN', facing[0], self.math('SUBTRACT', facing[1], 1e-5))

        def choose(condition, then, otherwise):
            return self.math('ADD', self.math('MULTIPLY', condition, then),
                             self.math('MULTIPLY', self.math('SUBTRACT', 1.0, condition), otherwise))
        u = self.math('DIVIDE', choose(up, x, choose(across, z, x)), side)
        v = self.math('DIVIDE', choose(up, z, y), side)
        cell = [self.math('FLOOR', u), self.math('FLOOR', v)]
        within = [self.math('SUBTRACT', u, cell[0]), self.math('SUBTRACT', v, cell[1])]
        edge = self.math('MINIMUM', *(self.math('MINIMUM', t, self.math('SUBTRACT', 1.0, t)) for t in within))
        stone = self.math('GREATER_THAN', edge, 0.015)
        shade = self.math('ADD', 0.86, self.math('MULTIPLY', 0.14, self.hash(self.math('ADD', cell[0], 0.5), self.math('ADD', cell[1], 0.5))))
        for scale, strength in ((7.0, 0.1), (41.0, 0.08)):
            grain = self.grain(self.math('MULTIPLY', u, scale), self.math('MULTIPLY', v, scale))
            shade = self.math('ADD', shade, self.math('MULTIPLY', strength, self.math('SUBTRACT', grain, 0.5)))
        return choose(stone, self.math('ADD', shade, 0.07), 0.62)


def rgba(color):
    return (*color[:3], 1.0)


def volume(nodes, given):
    """What is taken out of light, 1/m, and what an even light in the medium adds to it, per m."""
    rates = given['extinction']
    density = max(rates)
    if density <= 0:
        return None
    taken = nodes.new('ShaderNodeVolumeAbsorption', {'Density': density, 'Color': rgba([1 - rate / density for rate in rates])}).outputs[0]
    strength = max(given['glow'])
    if strength <= 0:
        return taken
    added = nodes.new('ShaderNodeEmission', {'Color': rgba([value / strength for value in given['glow']]), 'Strength': strength}).outputs[0]
    return nodes.new('ShaderNodeAddShader', {0: taken, 1: added}).outputs[0]


def material_of(given, sun):
    material = bpy.data.materials.new(given['name'])
    material.use_nodes = True
    nodes = Nodes(material.node_tree)
    output = nodes.new('ShaderNodeOutputMaterial')
    kind = given['kind']
    surface = None
    if kind == 'glass':
        surface = nodes.new('ShaderNodeBsdfGlass', {'IOR': given['index'], 'Color': rgba((1, 1, 1))}, distribution='SHARP').outputs[0]
        if given.get('lightPasses'):        # straight through to what lies below: no caustics, but no black shadow either
            shadow = nodes.new('ShaderNodeLightPath').outputs['Is Shadow Ray']
            clear = nodes.new('ShaderNodeBsdfTransparent').outputs[0]
            surface = nodes.new('ShaderNodeMixShader', {0: shadow, 1: surface, 2: clear}).outputs[0]
        inside = volume(nodes, given) if 'extinction' in given else None
        if inside is not None:
            nodes.links.new(inside, output.inputs['Volume'])
    else:
        if 'board' in given:
            color = nodes.board(given['board'])
        else:
            color = nodes.new('ShaderNodeRGB')
            color.outputs[0].default_value = rgba(given['color'])
            color = color.outputs[0]
        if kind == 'emission':
            surface = nodes.new('ShaderNodeEmission', {'Color': color, 'Strength': 1.0}).outputs[0]
        elif kind == 'solid':       # Solid.hlsl: an even light from all around, and the sun
            if given['tile'] > 0:
                color = nodes.new('ShaderNodeMixRGB', {0: 1.0, 1: color, 2: nodes.tiles(given['tile'])}, blend_type='MULTIPLY').outputs[0]
            around = nodes.new('ShaderNodeMixRGB', {0: 1.0, 1: color, 2: rgba(given['ambient'])}, blend_type='MULTIPLY').outputs[0]
            straight = nodes.math('SUBTRACT', 1.0, nodes.new('ShaderNodeLightPath').outputs['Is Diffuse Ray'])
            surface = nodes.new('ShaderNodeEmission', {'Color': around, 'Strength': straight}).outputs[0]
            direct = nodes.new('ShaderNodeBsdfDiffuse', {'Color': color}).outputs[0]
            if given['alpha'] < 1 and sun:      # by no chance, and without a shadow: a thin veil that would be noise
                facing = nodes.new('ShaderNodeVectorMath', {0: nodes.new('ShaderNodeNewGeometry').outputs['Normal'],
                                                            1: -swapped(sun['direction']).normalized()}, operation='DOT_PRODUCT').outputs['Value']
                bright = nodes.math('MULTIPLY', straight, nodes.math('MULTIPLY', nodes.math('MAXIMUM', facing, 0.0), sun['irradiance'] / math.pi))
                lit = nodes.new('ShaderNodeMixRGB', {0: 1.0, 1: color, 2: rgba(sun['color'])}, blend_type='MULTIPLY').outputs[0]
                direct = nodes.new('ShaderNodeEmission', {'Color': lit, 'Strength': bright}).outputs[0]
            surface = nodes.new('ShaderNodeAddShader', {0: surface, 1: direct}).outputs[0]
            if given['alpha'] < 1:
                clear = nodes.new('ShaderNodeBsdfTransparent').outputs[0]
                front = nodes.math('SUBTRACT', 1.0, nodes.new('ShaderNodeNewGeometry').outputs['Backfacing'])       # Cull Back
                surface = nodes.new('ShaderNodeMixShader', {0: nodes.math('MULTIPLY', front, given['alpha']), 1: clear, 2: surface}).outputs[0]
        else:
            raise ValueError(f'unknown kind of material {kind}')
    nodes.links.new(surface, output.inputs['Surface'])
    material.cycles.sample_as_light = False
    return material


# the rest of the scene


def add_camera(given):
    to_world = Matrix([given['matrix'][4 * i:4 * i + 4] for i in range(4)]).to_3x3()
    right, up, forward = (swapped(to_world @ Vector(axis)).normalized() for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    eye = swapped((given['matrix'][3], given['matrix'][7], given['matrix'][11]))
    camera = bpy.data.cameras.new('camera')
    camera.sensor_fit = 'VERTICAL'
    camera.angle = math.radians(given['fieldOfView'])
    camera.clip_start, camera.clip_end = given['near'], given['far']
    placed = bpy.data.objects.new('camera', camera)
    bpy.context.collection.objects.link(placed)
    placed.matrix_world = Matrix([(right[i], up[i], -forward[i], eye[i]) for i in range(3)] + [(0, 0, 0, 1)])
    bpy.context.scene.camera = placed


def add_sun(given):
    light = bpy.data.lights.new('sun', 'SUN')
    light.color = given['color'][:3]
    light.energy = given['irradiance']
    light.angle = math.radians(given['degrees'])
    placed = bpy.data.objects.new('sun', light)
    bpy.context.collection.objects.link(placed)
    placed.rotation_mode = 'QUATERNION'
    placed.rotation_quaternion = (-swapped(given['direction'])).to_track_quat('Z', 'Y')


def add_world(given, folder):
    world = bpy.data.worlds.new('world')
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes = Nodes(world.node_tree)
    if 'sky' in given:      # latitude and longitude, linear
        image = bpy.data.images.load(os.path.join(folder, given['sky']))
        image.colorspace_settings.name = 'Non-Color'
        color = nodes.new('ShaderNodeTexEnvironment', image=image).outputs[0]
    else:
        color = nodes.new('ShaderNodeRGB')
        color.outputs[0].default_value = rgba(given['color'])
        color = color.outputs[0]
    background = nodes.new('ShaderNodeBackground', {'Color': color, 'Strength': 1.0}).outputs[0]
    world.cycles_visibility.diffuse = False         # the even light of materials stands for it
    nodes.links.new(background, nodes.new('ShaderNodeOutputWorld').inputs['Surface'])


def prepare(given, folder):
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    cycles = scene.cycles
    cycles.device = 'CPU'
    cycles.samples = given['samples']
    cycles.seed = given['seed']
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.pixel_filter_type = 'BOX'        # one pixel wide: the mean over the pixel, as by supersampling
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = cycles.transparent_max_bounces = given['bounces']
    cycles.diffuse_bounces = 0
    cycles.sample_clamp_direct = 0
    cycles.sample_clamp_indirect = given['clamp']
    cycles.blur_glossy = 0
    render = scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = given['width'], given['height'], 100
    render.dither_intensity = 0
    for part in ('date', 'time', 'render_time', 'memory', 'hostname', 'frame', 'frame_range', 'camera', 'scene', 'filename', 'sequencer_strip'):
        setattr(render, 'use_stamp_' + part, False)        # the same scene gives the same bytes
    render.threads_mode, render.threads = 'FIXED', given['threads']
    render.image_settings.file_format, render.image_settings.color_mode, render.image_settings.color_depth = 'PNG', 'RGB', '8'
    render.image_settings.compression = 100
    render.filepath = os.path.join(folder, given['picture'])
    scene.view_settings.view_transform, scene.view_settings.look = 'Standard', 'None'
    scene.view_settings.exposure, scene.view_settings.gamma = 0, 1


def main(path):
    folder = os.path.dirname(os.path.abspath(path))
    with open(path, encoding='utf-8') as file:
        given = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    prepare(given, folder)
    add_camera(given['camera'])
    add_world(given['world'], folder)
    if 'sun' in given:
        add_sun(given['sun'])
    materials = {m['name']: material_of(m, given.get('sun')) for m in given['materials']}
    for placed in given['objects']:
        mesh = mesh_of(placed, folder)
        mesh.validate()
        if placed['smooth'] > 0:
            smooth(mesh, placed['smooth'])
        mesh.materials.append(materials[placed['material']])
        made = bpy.data.objects.new(placed['name'], mesh)
        bpy.context.collection.objects.link(made)
        made.matrix_world = matrix(placed['matrix'])
        made.visible_shadow = placed['shadow']
    bpy.ops.render.render(write_still=True)
    if 'mask' in given:
        draw_mask(given, folder)


def draw_mask(given, folder):
    """White where the material of the mask is seen first, black elsewhere; what one sees through is left out."""
    scene = bpy.context.scene
    scene.world.node_tree.nodes['Background'].inputs['Strength'].default_value = 0
    clear = {m['name'] for m in given['materials'] if m.get('alpha', 1) < 1}
    for made in list(scene.objects):
        if made.type == 'LIGHT' or made.type == 'MESH' and made.data.materials[0].name in clear:
            bpy.data.objects.remove(made)
    for material in bpy.data.materials:
        nodes = Nodes(material.node_tree)
        white = 1.0 if material.name == given['mask']['material'] else 0.0
        nodes.links.new(nodes.new('ShaderNodeEmission', {'Strength': white}).outputs[0], nodes.new('ShaderNodeOutputMaterial').inputs['Surface'])
    scene.cycles.samples = 8
    scene.render.filepath = os.path.join(folder, given['mask']['picture'])
    bpy.ops.render.render(write_still=True)


main(sys.argv[sys.argv.index('--') + 1])
