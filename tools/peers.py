"""The slicers that benches compare with rind, with the same settings: 60 mm/s, layers of 0.2 mm,
roads of 0.45 mm, three perimeters, an inside of 20 %, no skirt."""
import os
import re
import shutil

PROGRAMS = ('rind', 'prusa-slicer', 'slic3r', 'CuraEngine')
WIDTHS = ('extrusion_width', 'external_perimeter_extrusion_width', 'first_layer_extrusion_width',
          'infill_extrusion_width', 'perimeter_extrusion_width', 'solid_infill_extrusion_width',
          'top_infill_extrusion_width')
SPEEDS = ('bridge_speed', 'external_perimeter_speed', 'first_layer_speed', 'gap_fill_speed',
          'infill_speed', 'perimeter_speed', 'small_perimeter_speed', 'solid_infill_speed',
          'top_solid_infill_speed', 'max_print_speed')
SOLID = ('bottom_solid_layers', 'top_solid_layers')
PROFILE = {**{k: '0.45' for k in WIDTHS}, **{k: '60' for k in SPEEDS},
           'bed_shape': '0x0,300x0,300x300,0x300', 'brim_width': '0', 'cooling': '0',
           'filament_diameter': '1.75', 'fill_density': '20%', 'fill_pattern': 'rectilinear',
           'first_layer_height': '0.2', 'layer_height': '0.2', 'nozzle_diameter': '0.4', 'perimeters': '3', 'raft_layers': '0',
           'retract_length': '1', 'skirts': '0', 'support_material': '0', 'travel_speed': '130',
           'start_gcode': '', 'end_gcode': ''}
CURA_SOLID = ('top_layers', 'bottom_layers', 'initial_bottom_layers')
CURA = {'layer_height': '0.2', 'layer_height_0': '0.2', 'line_width': '0.45',
        'wall_line_count': '3', 'infill_sparse_density': '20', 'infill_line_distance': '2.25',
        'infill_pattern': 'lines', 'speed_print': '60', 'adhesion_type': 'none',
        'machine_width': '300', 'machine_depth': '300', 'machine_height': '1000000',
        'machine_center_is_zero': 'false'}


def cura_definition():
    folder = os.environ.get('CURA_RESOURCES', '/usr/share/cura/resources')
    path = folder + '/definitions/fdmprinter.def.json'
    return path if os.path.exists(path) else None


def command(program, build, part, folder, solid_layers=3):
    """The command that slices the part into a file in the folder, which must exist."""
    out = folder + '/out.gcode'
    if program == 'rind':
        return [build + '/rind', 'slice', part, '-o', out, '--quiet', '--wall-thickness',
                '%g' % (0.2 * solid_layers), '--set', 'perimeters=3', '--set', 'skirt_loops=0',
                '--stats', folder + '/stats.json']
    solid = str(solid_layers)
    if program == 'CuraEngine':
        options = [x for k, v in
                   {**CURA, **{k: solid for k in CURA_SOLID}}.items() for x in ('-s', k + '=' + v)]
        return (['CuraEngine', 'slice', '-j', cura_definition()] + options + ['-e0'] + options +
                ['-l', part, '-o', out])
    profile = folder + '.ini'
    with open(profile, 'w') as file:
        for key, value in {**PROFILE, **{k: solid for k in SOLID}}.items():
            file.write('%s = %s\n' % (key, value))
        if program == 'prusa-slicer':
            file.write('max_print_height = 1200\nperimeter_generator = classic\n'
                       'gcode_flavor = marlin\n')
    how = ['--export-gcode'] if program == 'prusa-slicer' else ['--no-gui']
    return [program, '--load', profile, '--dont-arrange'] + how + ['-o', out, part]


def installed(program, build):
    if program == 'rind':
        return os.path.exists(build + '/rind')
    return shutil.which(program) and (program != 'CuraEngine' or cura_definition())


def peak_bytes(pid):
    """Not wait4's figure, which includes this program's own memory from before exec."""
    try:
        with open('/proc/%d/status' % pid) as file:
            return 1024 * int(re.search(r'VmHWM:\s+(\d+)', file.read()).group(1))
    except (OSError, AttributeError):
        return 0
