"""Frames by VTK, one at a time, when they are asked for.

It is given the seconds that an answer may take, and says its version first. Then standard input begins with one JSON object in a line, the scene, and then it has the numbers of its meshes: for each mesh
three 32-bit floats and four bytes of colour per vertex, all floats first, and three 64-bit integers per triangle. After that,
each line is a JSON object that asks for one frame. Each answer is a JSON object in one line of standard output.
"""

import json
import os
import signal
import sys
import time

# An answer that takes longer ends this process, whatever VTK is at.
limit = int(sys.argv[1])
signal.alarm(limit)

# Whatever the libraries print themselves goes to standard error.
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
os.environ.setdefault("EGL_PLATFORM", "surfaceless")
os.environ.pop("DISPLAY", None)


def answer(**fields):
    answers.write(json.dumps(fields) + "\n")
    answers.flush()


try:
    import vtkmodules.all as vtk
except ImportError as error:
    answer(error=f"this Python has no VTK ({error})")
    sys.exit(0)

answer(version=vtk.vtkVersion.GetVTKVersionFull())
scene = json.loads(sys.stdin.buffer.readline() or sys.exit(0))


def exactly(count):
    data = sys.stdin.buffer.read(count)
    if len(data) != count:
        sys.exit(0)
    return data


kept = []


def array(kind, data, components, values):
    kept.append(data)
    made = kind()
    made.SetNumberOfComponents(components)
    made.SetVoidArray(data, values, 1)
    return made


def cells(triangles):
    data = exactly(24 * triangles)
    made = vtk.vtkCellArray()
    made.SetData(3, array(vtk.vtkTypeInt64Array, data, 1, 3 * triangles))
    return made


def mesh(shape):
    vertices = shape["vertices"]
    points = vtk.vtkPoints()
    points.SetData(array(vtk.vtkFloatArray, exactly(12 * vertices), 3, 3 * vertices))
    colors = array(vtk.vtkUnsignedCharArray, exactly(4 * vertices), 4, 4 * vertices)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells(shape["triangles"]))
    data.GetPointData().SetScalars(colors)
    return data, shape["opaque"]


meshes = [mesh(shape) for shape in scene["meshes"]]


def actor(data, opaque):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetColorModeToDirectScalars()
    mapper.InterpolateScalarsBeforeMappingOff()
    mapper.SetVBOShiftScaleMethod(0)
    mapper.StaticOn()
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    look = made.GetProperty()
    look.LightingOff()
    look.SetAmbient(1.0)
    look.SetDiffuse(0.0)
    look.SetSpecular(0.0)
    look.SetInterpolationToFlat()
    look.BackfaceCullingOff()
    made.ForceOpaqueOn() if opaque else made.ForceTranslucentOn()
    return made


class Mode:
    """A window whose renderer has one of VTK's ways to draw what is translucent."""

    def __init__(self, name):
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(*scene["background"])
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetAlphaBitPlanes(1)
        self.window.SetSize(*scene["size"])
        self.window.AddRenderer(self.renderer)
        self.passes = 0
        first = None
        for data, opaque in meshes:
            made = actor(data, opaque)
            self.renderer.AddActor(made)
            if not opaque and first is None:
                first = made.GetMapper()
        if first is not None:
            # VTK's mapper says so each time it draws.
            first.AddObserver("StartEvent", self.drawn)
        if name == "alpha":
            self.renderer.UseDepthPeelingOff()
            # Otherwise it would draw a weighted mean.
            self.renderer.UseOITOff()
        else:
            self.peel(name)

    def drawn(self, *_):
        self.passes += 1

    def peel(self, name):
        # Named passes, because a renderer that is only told to peel chooses between the two itself.
        peeling = {"peel": vtk.vtkDepthPeelingPass, "dual": vtk.vtkDualDepthPeelingPass}[name]()
        # No limit: 0 says so to one of them, and the other peels nothing then.
        peeling.SetMaximumNumberOfPeels({"peel": 0, "dual": 100000}[name])
        peeling.SetOcclusionRatio(0.0)
        peeling.SetTranslucentPass(vtk.vtkTranslucentPass())
        steps = vtk.vtkRenderPassCollection()
        for step in (vtk.vtkLightsPass(), vtk.vtkOpaquePass(), peeling):
            steps.AddItem(step)
        sequence = vtk.vtkSequencePass()
        sequence.SetPasses(steps)
        camera = vtk.vtkCameraPass()
        camera.SetDelegatePass(sequence)
        self.renderer.SetPass(camera)

    def frame(self, seen):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*seen["eye"])
        camera.SetFocalPoint(*seen["target"])
        camera.SetViewUp(*seen["up"])
        camera.SetViewAngle(seen["fov"])
        camera.SetClippingRange(seen["near"], seen["far"])
        self.passes = 0
        begun = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return (time.perf_counter() - begun) * 1e3

    def save(self, path):
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.SetInputBufferTypeToRGB()
        grab.ReadFrontBufferOff()
        writer = vtk.vtkPNGWriter()
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(path)
        writer.Write()


modes = {}
for line in sys.stdin.buffer:
    asked = json.loads(line)
    signal.alarm(limit)
    if asked["mode"] not in modes:
        modes[asked["mode"]] = Mode(asked["mode"])
    mode = modes[asked["mode"]]
    ms = mode.frame(asked["camera"])
    if "picture" in asked:
        mode.save(asked["picture"])
    answer(ms=ms, passes=mode.passes)
    signal.alarm(0)
