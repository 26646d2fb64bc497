# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong input ends with exit code 1 before any work, and with one message that
names the parameter and the way out."""
import pathlib

import pytest
from lumbricus_run import run
from mistakes import check_one_message, names, on_ranks, run_all

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"
CHAIN = HERE / "chain.prm"

# No base: the change is all of the file, of this kind.
PRM, JSON = ".prm", ".json"

FORMULA = "Muscles/biceps/expression/Formula"
PRESSURE = "Boundary conditions/push/follower pressure/Pressure"


def load(kind, parameter, value):
    """One more load, of this kind, on the face at the end of y."""
    return f"""
subsection Boundary conditions
  set Names = wall, push, more
  subsection more
    set Boundary = y max
    set Type = {kind}
    subsection {kind}
      set {parameter} = {value}
    end
  end
end
"""


def fibres(kind, parameter, value):
    """Other fibres for the muscle."""
    return f"""
subsection Muscles
  subsection biceps
    set Fibres = {kind}
    subsection {kind}
      set {parameter} = {value}
    end
  end
end
"""


def tube(text):
    """Another body, with one change."""
    return f"""
subsection Geometry
  set Shape = open cylinder
  subsection open cylinder
    set {text}
  end
end
subsection Tissues
  subsection liquid
    subsection Neo-Hooke
      set a = 0.001
    end
  end
end
"""


def pull(text, formula="t"):
    """A second muscle of the block, which pulls."""
    return another_muscle(
        "set Fibres = longitudinal\nset Action = active stress\n"
        "set Activation = expression\nsubsection expression\n"
        f"set Formula = {formula}\nend\n"
        f"subsection active stress\n{text}\nend")


def another_muscle(text):
    """A second muscle of the block."""
    return f"""
subsection Tissues
  subsection flesh
    set Muscles = biceps, triceps
  end
end
subsection Muscles
  subsection triceps
    {text}
  end
end
"""


# What is wrong; the base; settings, or text that follows the base; what the
# message has to say: the parameter first, the way out last.
MISTAKES = [
    # Adaptivity.
    ("levels of a tissue that is not there", CHAIN,
     ["Adaptivity/Levels of tissues=skin: 1 - 2"],
     ["'Adaptivity/Levels of tissues'", "'skin'", "does not have",
      "Name one that it has", "'wall'", "'septum'", "'cap'", "'liquid'"]),
    ("levels that are none", CHAIN,
     ["Adaptivity/Levels of tissues=wall: 3 - 1"],
     ["'Adaptivity/Levels of tissues'", "'3 - 1'", "'wall'", "like '1 - 3'"]),
    ("one level only", CHAIN, ["Adaptivity/Levels of tissues=wall: 3"],
     ["'Adaptivity/Levels of tissues'", "'3'", "two numbers"]),
    ("levels the wrong way round", CHAIN,
     ["Adaptivity/Coarsest level=2", "Adaptivity/Finest level=1"],
     ["'Adaptivity/Finest level' is 1", "'Coarsest level', 2",
      "Raise it, or lower that"]),
    ("levels without a name", CHAIN, ["Adaptivity/Levels of tissues=1 - 2"],
     ["'Adaptivity/Levels of tissues' is '1 - 2'", "'name: value'"]),
    ("rule that was not chosen", CHAIN,
     ["Adaptivity/number of unknowns/Target=100"],
     ["'Adaptivity/number of unknowns' is not used",
      "'Adaptivity/Marking' is 'fraction of error'"]),
    ("estimator that does not exist", CHAIN, ["Adaptivity/Estimator=kelly"],
     ["'Adaptivity/Estimator'", "'displacement jump'", "'stress jump'"]),
    # Chambers without cells.
    ("content of chambers that have cells", CHAIN, ["Cavities/Content=gas"],
     ["'Cavities/Content' is 'gas'", "no chamber without cells",
      "'Geometry/segment chain/Liquid'"]),
    ("load in a chamber", CHAIN,
     ["Geometry/segment chain/Liquid=cavity",
      "Boundary conditions/Names=push", "Boundary conditions/push/Type=spring",
      "Boundary conditions/push/Boundary=cavity 1"],
     ["'Boundary conditions/push/Boundary'", "'cavity 1'",
      "no such boundary", "'head', 'tail', 'skin'"]),
    ("pores of chambers that have cells", CHAIN, ["Cavities/Pores=1"],
     ["'Cavities/Pores' is '1'", "no chamber without cells",
      "'Geometry/segment chain/Liquid'"]),
    ("content of a segment that is not there", CHAIN,
     ["Geometry/segment chain/Liquid=cavity",
      "Cavities/Segments with their own content=40"],
     ["'Cavities/Segments with their own content'", "'Segment 40'",
      "not within the chain"]),
    ("content of a chamber that has cells", CHAIN,
     ["Cavities/Segments with their own content=2"],
     ["'Cavities/Segments with their own content' has segment 2",
      "no cavity", "Take it out"]),
    ("pump with a negative volume", CHAIN,
     ["Geometry/segment chain/Liquid=cavity", "Cavities/Content=volume",
      "Cavities/volume/Relative volume=1 - 2*t*(s == 2)"],
     ["'Cavities/volume/Relative volume' is 0", "segment 2", "at time 0.5",
      "more than 0", "At rest it is 1"]),
    ("pump whose volume is no number", CHAIN,
     ["Geometry/segment chain/Liquid=cavity",
      "Cavities/Segments with their own content=2",
      "Cavities/Segment 2/Content=volume",
      "Cavities/Segment 2/volume/Relative volume=log(0.5 - t)"],
     ["'Cavities/Segment 2/volume/Relative volume'", "log(0.5 - t)",
      "Change it"]),
    ("gas below vacuum", CHAIN,
     ["Geometry/segment chain/Liquid=cavity", "Cavities/Content=gas",
      "Cavities/gas/Absolute pressure outside=0.1 - t"],
     ["'Cavities/gas/Absolute pressure outside'", "-0", "segment 1",
      "at time", "vacuum"]),
    ("pores that pump", CHAIN,
     ["Geometry/segment chain/Liquid=cavity", "Cavities/Pores=1 - 2*t"],
     ["'Cavities/Pores'", "-0", "low to high", "at least 0"]),
    ("pores between gas and liquid", CHAIN,
     ["Geometry/segment chain/Liquid=cavity",
      "Cavities/Segments with their own content=1",
      "Cavities/Segment 1/Content=gas", "Cavities/Pores=1"],
     ["'Cavities/Pores'", "segments 1, with 'gas', and 2, with 'liquid'",
      "same on both sides"]),
    ("leak of a gas that keeps its heat", CHAIN,
     ["Geometry/segment chain/Liquid=cavity", "Cavities/Content=gas",
      "Cavities/gas/Exponent=1.4", "Cavities/Leak=1"],
     ["'Cavities/Leak'", "segment 1", "'gas' keeps its heat",
      "'Exponent' to 1"]),
    ("gas without pressure", CHAIN,
     ["Geometry/segment chain/Liquid=cavity", "Cavities/Content=gas",
      "Cavities/gas/Absolute pressure at rest=0"],
     ["'Cavities/gas/Absolute pressure at rest'", "'0'"]),
    ("slip of a liquid without cells", CHAIN,
     ["Geometry/segment chain/Liquid=cavity", "Interface/Coupling=slip"],
     ["'Interface/Coupling' lets liquid slip", "no chamber",
      "Set it to 'tied'"]),
    ("weight between pistons", CHAIN,
     ["Geometry/Shape=open cylinder", "Geometry/open cylinder/Liquid=cavity",
      "Body forces/Names=weight", "Body forces/weight/Type=weight",
      "Body forces/weight/weight/Gravity=if(t < 0.5, 0, 9810); 0; 0",
      "Boundary conditions/Names=left, right",
      "Boundary conditions/left/Boundary=head",
      "Boundary conditions/left/Type=displacement",
      "Boundary conditions/right/Boundary=tail",
      "Boundary conditions/right/Type=displacement"],
     ["liquid between pistons in segment 1", "'weight'", "'Density'"]),
    # Weight.
    ("weight across a plane of symmetry", CHAIN,
     ["Body forces/Names=weight", "Body forces/weight/Type=weight",
      "Body forces/weight/weight/Gravity=0; 0; -9810",
      "Geometry/segment chain/Cross-section=quarter",
      "Boundary conditions/Names=hold", "Boundary conditions/hold/Boundary=head",
      "Boundary conditions/hold/Type=displacement"],
     ["The body force 'weight' is not symmetric to the plane of symmetry z = 0",
      "'Geometry/segment chain/Cross-section' to 'full'"]),
    ("weight that nothing holds", CHAIN,
     ["Body forces/Names=weight", "Body forces/weight/Type=weight",
      "Body forces/weight/weight/Gravity=9.81e6*t; 0; 0",
      "Boundary conditions/Names="],
     ["The loads are not in balance", "'weight'", "no other support holds",
      "hold the body"]),
    ("weight of a liquid by name", CHAIN,
     ["Body forces/Names=weight", "Body forces/weight/Type=weight",
      "Body forces/weight/Tissues=liquid"],
     ["'Body forces/weight/Tissues' has 'liquid'", "which is a liquid",
      "Give some of"]),
    # Patches of a block.
    ("patch that cuts a cell", BLOCK,
     ["Geometry/block/Patches=half", "Geometry/block/half/To=0.5, 1"],
     ["'Geometry/block/half/To'", "y = 0.5", "not on a mesh line",
      "Move it to 1", "'Cells'"]),
    ("patch in a plane of symmetry", BLOCK,
     ["Geometry/block/Patches=side", "Geometry/block/side/Face=y min",
      "Geometry/block/side/To=2, 1", "Geometry/block/Symmetry=y"],
     ["'Geometry/block/side/Face'", "'y min'", "plane of symmetry",
      "'Geometry/block/Symmetry'"]),
    ("patch with the name of a face", BLOCK, ["Geometry/block/Patches=x min"],
     ["'Geometry/block/Patches'", "'x min' is the name of a face",
      "Choose another"]),
    ("patch beyond the block", BLOCK,
     ["Geometry/block/Patches=half", "Geometry/block/half/To=1, 3"],
     ["'Geometry/block/half/To'", "z = 3", "outside of the block",
      "ends at 1", "Give a smaller number"]),
    ("patch without a width", BLOCK,
     ["Geometry/block/Patches=half", "Geometry/block/half/From=1, 0",
      "Geometry/block/half/To=1, 1"],
     ["'Geometry/block/half/To'", "along y", "no width",
      "larger number than in 'From'"]),
    ("patches that overlap", BLOCK,
     ["Geometry/block/Patches=a, b", "Geometry/block/a/To=1, 1",
      "Geometry/block/b/To=1, 1"],
     ["'Geometry/block/Patches'", "'a' and 'b' overlap on 'x max'",
      "Make them disjoint"]),
    ("patch twice", BLOCK,
     ["Geometry/block/Patches=a, a", "Geometry/block/a/To=1, 1"],
     ["'Geometry/block/Patches' has 'a' twice", "Leave one of them out"]),
    # Names.
    ("misspelt parameter", BLOCK, ["Time/Ende=1"],
     ["'Time/Ende' is unknown", "Did you mean 'Time/End'?"]),
    ("misspelt parameter in a file", BLOCK, "\nsubsection Time\n"
     "  set Largest stap = 1\nend\n",
     ["case.prm, line 4", "'Time/Largest stap' is unknown",
      "Did you mean 'Time/Largest step'?"]),
    ("misspelt section", BLOCK, ["Tissue/flesh/Neo-Hooke/a=1"],
     ["section 'Tissue' is unknown", "Did you mean 'Tissues'?"]),
    ("nothing like it", BLOCK, ["Time/Gravity=9.81"],
     ["'Time/Gravity' is unknown", "known there", "'Largest step'",
      "--parameters"]),
    ("shape that was not chosen", BLOCK, ["Geometry/segment chain/Radius=1"],
     ["'Geometry/segment chain' is not used", "'Geometry/Shape' is 'block'",
      "Choose 'segment chain' there, or remove the section"]),
    ("law that was not chosen", BLOCK, ["Tissues/flesh/Mooney-Rivlin/b=1"],
     ["'Tissues/flesh/Mooney-Rivlin' is not used",
      "'Tissues/flesh/Law' is 'Neo-Hooke'", "Choose 'Mooney-Rivlin' there"]),
    # The section of the default was taken in silence.
    ("law that is the default but was not chosen", PRM, """
subsection Geometry
  set Shape = block
end
subsection Tissues
  subsection block
    set Law = Hooke
    subsection Neo-Hooke
      set a = 7
    end
  end
end
""", ["line 8", "'Tissues/block/Neo-Hooke' is not used",
      "'Tissues/block/Law' is 'Hooke'"]),
    ("activation that was not chosen", BLOCK, ["Muscles/biceps/wave/Duty=1"],
     ["'Muscles/biceps/wave' is not used",
      "'Muscles/biceps/Active stretch' is 'expression'",
      "Choose 'wave' there"]),
    ("load type that was not chosen", BLOCK,
     ["Boundary conditions/push/spring/Stiffness=1"],
     ["'Boundary conditions/push/spring' is not used",
      "'Boundary conditions/push/Type' is 'follower pressure'"]),
    ("solver that was not chosen", BLOCK,
     ["Linear solver/kept factor/Most iterations=9"],
     ["'Linear solver/kept factor' is not used",
      "'Linear solver/Method' is 'direct'"]),
    ("tissue the shape does not have", BLOCK, ["Tissues/septum/Law=Neo-Hooke"],
     ["'Tissues/septum' is unknown", "'flesh'"]),
    ("muscle no tissue has", BLOCK, ["Muscles/triceps/Fibres=radial"],
     ["'Muscles/triceps'", "Did you mean 'Muscles/biceps'?"]),
    # A setting may list fewer names than the file; a file may not.
    ("load that is not listed", BLOCK, """
subsection Boundary conditions
  set Names = push
end
""", ["'Boundary conditions/wall'", "'push'", "lists its name"]),

    ("parameter without its section", BLOCK, ["Duty=1"],
     ["'Duty' is unknown", "known there", "'Title', 'Units'"]),
    ("parameter of another section", BLOCK, ["Smallest step=0.1"],
     ["'Smallest step' is unknown", "Did you mean 'Time/Smallest step'?"]),
    ("section as a parameter", BLOCK, ["Time=1"],
     ["'Time' is unknown: that is a section", "Set a parameter in it"]),
    ("parameter as a section", BLOCK, ["Time/End/Hour=1"],
     ["section 'Time/End' is unknown: that is a parameter",
      "Set it to a value"]),
    ("segment without a rule", CHAIN, ["Geometry/segment chain/Segment 3/"
                                       "Radius=1"],
     ["'Geometry/segment chain/Segment 3' is unknown or not used",
      "another parameter chooses it or lists its name"]),
    # These ended with exit code 3 and deal.II's 'No such node'.
    ("tissue without a name", BLOCK, ["Geometry/block/Tissue name="],
     ["'Geometry/block/Tissue name' is ''", "a name, without '/'"]),
    ("layer without a name", CHAIN,
     ["Geometry/segment chain/Wall layers=wall,, skin"],
     ["'Geometry/segment chain/Wall layers' is 'wall,, skin'",
      "1 to 64 entries, each a name"]),
    ("load without a name", BLOCK, ["Boundary conditions/Names=wall,, push"],
     ["'Boundary conditions/Names' is 'wall,, push'", "each a name"]),
    ("muscle with a slash in its name", BLOCK,
     ["Tissues/flesh/Muscles=bi/ceps"],
     ["'Tissues/flesh/Muscles' is 'bi/ceps'", "without '/'"]),
    ("load twice", BLOCK, ["Boundary conditions/Names=wall, push, push"],
     ["'Boundary conditions/Names' has 'push' twice",
      "Leave one of them out"]),
    # It contracted twice as much.
    ("muscle twice", BLOCK, ["Tissues/flesh/Muscles=biceps, biceps"],
     ["'Tissues/flesh/Muscles' has 'biceps' twice", "Leave one of them out"]),

    # Types and ranges.
    ("word for a number", BLOCK, ["Tissues/flesh/Neo-Hooke/a=stiff"],
     ["'Tissues/flesh/Neo-Hooke/a' is 'stiff'", "a number > 0"]),
    ("negative stiffness", BLOCK, ["Tissues/flesh/Neo-Hooke/a=-1"],
     ["'Tissues/flesh/Neo-Hooke/a' is '-1'", "a number > 0"]),
    ("negative stiffness in a file", BLOCK,
     "subsection Tissues\n  subsection flesh\n    subsection Neo-Hooke\n"
     "      set a = \\\n -1\n    end\n  end\nend\n",
     ["case.prm, line 5", "'Tissues/flesh/Neo-Hooke/a' is '-1'",
      "a number > 0"]),
    # It ended with exit code 3 and 'stod'.
    ("number that is next to zero", BLOCK, ["Time/End=1e-320"],
     ["'Time/End' is '1e-320'", "a number > 0, from 1e-100 to 1e100"]),
    # Its cube is infinite, and the solve failed with exit code 2.
    ("number that is next to infinite", BLOCK,
     ["Tissues/flesh/Neo-Hooke/a=1e200"],
     ["'Tissues/flesh/Neo-Hooke/a' is '1e200'", "from 1e-100 to 1e100"]),
    ("NaN", BLOCK, ["Tissues/flesh/Neo-Hooke/nu=nan"],
     ["'Tissues/flesh/Neo-Hooke/nu' is 'nan'", "a number from 0 to 0.5"]),
    ("more than an int holds", BLOCK, ["Newton/Most iterations=9999999999"],
     ["'Newton/Most iterations' is '9999999999'",
      "a whole number, at least 1"]),
    ("no value", BLOCK, ["Tissues/flesh/Law="],
     ["'Tissues/flesh/Law' is ''", "one of 'Demiray', 'Gent', 'Guccione', 'Hooke'"]),
    ("unit", BLOCK, ["Time/End=1 s"],
     ["'Time/End' is '1 s'", "a number > 0"]),
    ("decimal comma", BLOCK, ["Time/End=1,5"],
     ["'Time/End' is '1,5'", "a number > 0"]),
    ("axis there is not", BLOCK, ["Geometry/block/Symmetry=x, w"],
     ["'Geometry/block/Symmetry' is 'x, w'", "a list out of 'x', 'y', 'z'"]),
    ("refinements that are too many", CHAIN, ["Mesh/Global refinements=9"],
     ["'Mesh/Global refinements' is '9'", "a whole number from 0 to 8"]),
    # It went on until the machine had no memory left.
    ("refinements for which no memory is", CHAIN,
     ["Mesh/Global refinements=8"],
     ["'Mesh/Global refinements' is 8", "6.71e+08 cells", "GB available",
      "Refine less often"]),
    ("cells of a block that are too many", BLOCK,
     ["Geometry/block/Cells=1000000, 1000000, 1000000"],
     ["'Geometry/block'", "1e+18 cells", "at most 1e+07",
      "'Mesh/Global refinements'"]),
    ("cells of a chain that are too many", CHAIN,
     ["Geometry/segment chain/Cells around a quarter=1000000"],
     ["'Geometry/segment chain'", "cells", "at most 1e+07",
      "'Mesh/Global refinements'"]),
    ("cells of a tube that are too many", PRM,
     tube("Cells along the cylinder = 1000000000"),
     ["'Geometry/open cylinder'", "at most 1e+07",
      "'Mesh/Global refinements'"]),
    ("odd number of cells along a tube", PRM,
     tube("Cells along the cylinder = 3"),
     ["'Geometry/open cylinder/Cells along the cylinder' is 3", "even"]),
    ("a law of Yeoh without stiffness", BLOCK,
     ["Tissues/flesh/Law=Yeoh", "Tissues/flesh/Yeoh/C2=-0.5"],
     ["'Tissues/flesh/Yeoh/C2' is so negative", "Raise 'C2' or 'C3'"]),
    ("terms of Ogden's law with one number", BLOCK,
     ["Tissues/flesh/Law=Ogden", "Tissues/flesh/Ogden/Moduli=1, 2"],
     ["'Tissues/flesh/Ogden/Exponents' has 1 numbers, but 'Moduli' has 2"]),
    ("a term of Ogden's law without stiffness", BLOCK,
     ["Tissues/flesh/Law=Ogden", "Tissues/flesh/Ogden/Moduli=1, 2",
      "Tissues/flesh/Ogden/Exponents=2, -2"],
     ["'Tissues/flesh/Ogden/Exponents' has in term 2 a number",
      "sign"]),
    ("elastic fibres without a direction", BLOCK,
     ["Tissues/flesh/Elastic fibres/Names=net"],
     ["'Tissues/flesh/Elastic fibres/net/Fibres' is not set",
      "the family of fibres 'net' has no direction"]),
    ("too much dispersion", BLOCK,
     ["Tissues/flesh/Elastic fibres/Names=net",
      "Tissues/flesh/Elastic fibres/net/Fibres=longitudinal",
      "Tissues/flesh/Elastic fibres/net/kappa=0.5"],
     ["'Tissues/flesh/Elastic fibres/net/kappa' is '0.5'"]),
    *((f"coupling {what}", BLOCK,
       ["Tissues/flesh/Elastic fibres/Names=net, warp",
        "Tissues/flesh/Elastic fibres/net/Fibres=longitudinal",
        "Tissues/flesh/Elastic fibres/warp/Fibres=direction",
        "Tissues/flesh/Elastic fibres/warp/direction/Direction=0, 1, 0",
        "Tissues/flesh/Fibre couplings/Names=c",
        f"Tissues/flesh/Fibre couplings/c/Between={between}", *more], words)
      for what, between, more, words in (
          ("between one", "net", [],
           ["'Tissues/flesh/Fibre couplings/c/Between' has 1 names",
            "two families of 'Elastic fibres'"]),
          ("between three", "net, warp, weft", [],
           ["'Tissues/flesh/Fibre couplings/c/Between' has 3 names"]),
          ("of a family with itself", "net, net", [],
           ["'Tissues/flesh/Fibre couplings/c/Between' has 'net' twice"]),
          ("with a family there is not", "net, weft", [],
           ["'Tissues/flesh/Fibre couplings/c/Between' has 'weft', which is none "
            "of the tissue's 'Elastic fibres'"]),
          ("without stiffness", "net, warp",
           ["Tissues/flesh/Fibre couplings/c/a=0"],
           ["'Tissues/flesh/Fibre couplings/c/a' is '0'"]),
          ("that softens", "net, warp", ["Tissues/flesh/Fibre couplings/c/b=-1"],
           ["'Tissues/flesh/Fibre couplings/c/b' is '-1'"]))),
    ("fibres of a ventricle in a block", BLOCK,
     ["Tissues/flesh/Law=Guccione", "Tissues/flesh/Guccione/Fibres=ellipsoidal"],
     ["'Tissues/flesh/Guccione/ellipsoidal'", "'truncated ellipsoid'"]),
    ("a liquid with elastic fibres", CHAIN,
     ["Tissues/liquid/Elastic fibres/Names=net",
      "Tissues/liquid/Elastic fibres/net/Fibres=longitudinal"],
     ["'Tissues/liquid' has elastic fibres", "which a liquid has not"]),
    ("a liquid with viscous branches", CHAIN,
     ["Tissues/liquid/Viscous branches/Names=slow"],
     ["'Tissues/liquid' has viscous branches, which a liquid has not"]),
    *(("a viscous branch that is none", BLOCK,
       ["Tissues/flesh/Viscous branches/Names=slow",
        f"Tissues/flesh/Viscous branches/slow/{key}={value}"],
       [f"'Tissues/flesh/Viscous branches/slow/{key}' is '{value}'"])
      for key, value in (("Shear modulus", 0), ("Relaxation time", -1))),
    ("a viscous branch twice", BLOCK,
     ["Tissues/flesh/Viscous branches/Names=slow, slow"],
     ["'Tissues/flesh/Viscous branches/Names'", "'slow' twice"]),
    ("Poisson's ratio above 0.5", BLOCK, ["Tissues/flesh/Neo-Hooke/nu=0.6"],
     ["'Tissues/flesh/Neo-Hooke/nu' is '0.6'", "a number from 0 to 0.5"]),
    ("negative radius", CHAIN, ["Geometry/segment chain/Radius=-2"],
     ["'Geometry/segment chain/Radius' is -2 mm for segment 1",
      "a number > 0"]),
    ("infinite length", BLOCK, ["Geometry/block/Lengths=1, inf, 1"],
     ["'Geometry/block/Lengths' is '1, inf, 1'", "3 entries",
      "a number > 0"]),
    ("two lengths for three axes", BLOCK, ["Geometry/block/Lengths=1, 1"],
     ["'Geometry/block/Lengths' is '1, 1'", "3 entries"]),
    ("broken number of cells", BLOCK, ["Geometry/block/Cells=1, 1.5, 1"],
     ["'Geometry/block/Cells' is '1, 1.5, 1'", "a whole number, at least 1"]),
    ("no segments", CHAIN, ["Geometry/segment chain/Number of segments=0"],
     ["'Geometry/segment chain/Number of segments' is '0'",
      "a whole number from 1 to 10000"]),
    ("word that is neither true nor false", BLOCK,
     ["Geometry/block/Liquid=maybe"],
     ["'Geometry/block/Liquid' is 'maybe'", "true or false"]),
    ("shape there is not", BLOCK, ["Geometry/Shape=sphere"],
     ["'Geometry/Shape' is 'sphere'",
      "one of 'block', 'hollow sphere', 'mesh file', 'open cylinder', 'segment chain', "
      "'truncated ellipsoid'"]),
    ("load type there is not", BLOCK,
     ["Boundary conditions/push/Type=gravity"],
     ["'Boundary conditions/push/Type' is 'gravity'", "'dead traction'"]),
    ("solver there is not", BLOCK, ["Linear solver/Method=magic"],
     ["'Linear solver/Method' is 'magic'", "'direct', 'kept factor'"]),
    ("reset mode there is not", BLOCK, ["Reset/Mode=none"],
     ["'Reset/Mode' is 'none'", "'isochoric', 'full'"]),
    ("no end of time", BLOCK, ["Time/End=0"],
     ["'Time/End' is '0'", "a number > 0"]),
    ("smallest step above the largest", BLOCK, ["Time/Smallest step=1"],
     ["'Time/Smallest step'", "'Time/Largest step'", "1, 0.5 and 0.5",
      "Change them so that"]),
    ("first step above the largest", BLOCK, ["Time/First step=2"],
     ["'Time/First step'", "'Time/Largest step'", "Change them so that"]),
    # Steps as small did not end.
    ("results more often than steps", BLOCK,
     ["Time/Result interval=0.00001"],
     ["'Time/Result interval' is 1e-05,", "'Time/Smallest step', 0.0001",
      "Raise it, or set it to 0"]),
    ("odd number of cells", CHAIN,
     ["Geometry/segment chain/Cells along a segment=3"],
     ["'Geometry/segment chain/Cells along a segment' is 3", "even"]),
    ("odd number of cells around", CHAIN,
     ["Geometry/segment chain/Cells around a quarter=3"],
     ["'Geometry/segment chain/Cells around a quarter' is 3", "even"]),
    ("formula of the mesh that does not parse", BLOCK,
     ["Mesh/Refine where=x >"],
     ["'Mesh/Refine where'", "'x >'", "Unexpected end", "It may use"]),
    ("formula of the mesh without a value", BLOCK,
     ["Mesh/Refine where=1/(x - 1)", "Mesh/Local refinements=1"],
     ["'Mesh/Refine where'", "'1/(x - 1)' has no value",
      "point (1, 0.5, 0.5)", "defined in all of the body"]),
    # Other results with every run and on every number of ranks.
    ("formula of chance", BLOCK, [PRESSURE + "=0.01*rand()"],
     [f"'{PRESSURE}'", "'0.01*rand()'", "it has 'rand'", "another number",
      "a formula in x, y, z"]),
    ("formula of chance with a seed", BLOCK,
     [FORMULA + "=1 - 0.1*rand_seed(7)*t"],
     [f"'{FORMULA}'", "it has 'rand_seed'", "another number"]),
    ("point in hexadecimal numbers", BLOCK, ["Output/Points=0x0, 0, 0"],
     ["'Output/Points'", "'0x0, 0, 0' is not a point", "three numbers"]),
    # --check took it for right, and the run found it after its log had begun.
    ("point outside of the body", BLOCK, ["Output/Points=0, 0, 0; 1, 3, 0"],
     ["'Output/Points'", "(1, 3, 0) is not in the body",
      "The nearest point of the mesh at rest is (1, ", "mm away",
      "more than 0.1 of the cell there", "Give a point of the body"]),
    ("point of two numbers", BLOCK, ["Output/Points=0, 0, 0; 1, 2"],
     ["'Output/Points'", "'1, 2' is not a point", "three numbers",
      "'0, 0, 2; 1, 0, 2'"]),
    # This was a point of the body.
    ("point that is NaN", BLOCK, ["Output/Points=nan, 0, 0"],
     ["'Output/Points'", "'nan, 0, 0' is not a point", "three numbers"]),

    # The body.
    ("two rules for one segment", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=1-2, 2"],
     ["'Geometry/segment chain/Segments with their own measures'",
      "two rules for segment 2", "Make the ranges disjoint"]),
    ("range beyond the chain", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=2-9"],
     ["'Geometry/segment chain/Segments with their own measures'",
      "'Segments 2-9' is not within the chain", "from 1 (head) to 2 (tail)"]),
    ("not a range", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=first"],
     ["'Geometry/segment chain/Segments with their own measures'", "'first'",
      "Write a list like '1, 8-10'"]),
    ("segment beyond the chain", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=3",
      "Geometry/segment chain/Segment 3/Radius=1"],
     ["'Geometry/segment chain/Segments with their own measures'",
      "'Segment 3' is not within the chain", "from 1 (head) to 2 (tail)"]),
    ("thicknesses of a segment that are too many", CHAIN,
     ["Geometry/segment chain/Segments with their own measures=1",
      "Geometry/segment chain/Segment 1/Wall layer thicknesses=1, 2"],
     ["'Geometry/segment chain/Segment 1/Wall layer thicknesses' has 2",
      "'Geometry/segment chain/Wall layers' has 1", "one thickness"]),
    ("more layers than thicknesses", CHAIN,
     ["Geometry/segment chain/Wall layers=wall, skin"],
     ["'Geometry/segment chain/Wall layer thicknesses' has 1 entries",
      "'Geometry/segment chain/Wall layers' has 2",
      "Give one thickness for every layer"]),
    ("layer with the name of the liquid", CHAIN,
     ["Geometry/segment chain/Wall layers=wall, liquid"],
     ["'Geometry/segment chain/Wall layers'", "'liquid'",
      "Give every layer a name of its own"]),
    ("stiff liquid", CHAIN, ["Tissues/liquid/Neo-Hooke/a=0.05"],
     ["'Tissues/liquid/Neo-Hooke'", "0.05", "more than a tenth",
      "0.23 ('cap')", "1% of the wall's stiffness or less", "0.0023"]),

    # Muscles.
    ("muscle without fibres", BLOCK,
     another_muscle("set Active stretch = wave"),
     ["'Muscles/triceps/Fibres' is not set", "no fibres",
      "Set it to one of 'circumferential'", "'vector expression'."]),
    ("muscle without active stretch", BLOCK,
     another_muscle("set Fibres = radial"),
     ["'Muscles/triceps/Active stretch' is not set", "no active stretch",
      "Set it to one of 'expression', 'server', 'table', 'wave'."]),
    ("muscle that is listed, but has no section", BLOCK,
     ["Tissues/flesh/Muscles=biceps, triceps"],
     ["'Muscles/triceps/Fibres' is not set", "Set it to one of"]),
    ("muscle in a liquid", BLOCK, ["Geometry/block/Liquid=true"],
     ["'Tissues/flesh/Muscles' has to be empty", "a liquid has no fibres",
      "Put the muscle into a tissue of the wall"]),
    ("active stretch of zero", BLOCK, [FORMULA + "=1 - 2*t"],
     ["'Muscles/biceps/expression'", "segment 1", "at time 0.5",
      "a number > 0", "Change"]),
    ("active stretch that is NaN late", BLOCK, [FORMULA + "=sqrt(0.985 - t)"],
     ["'Muscles/biceps/expression'", "segment 1", "at time 0.99", "nan",
      "a number > 0"]),
    ("active stretch that does not parse", BLOCK, [FORMULA + "=1 - 0.1*q"],
     [f"'{FORMULA}'", "'1 - 0.1*q'", '"q"', "It may use t, x, y, z, n, pi, s"]),
    ("active stretch that breaks off", BLOCK, [FORMULA + "=1 +"],
     [f"'{FORMULA}'", "Unexpected end of expression", "It may use"]),
    ("active stretch that is empty", BLOCK, [FORMULA + "="],
     [f"'{FORMULA}'", "it is empty", "It may use"]),
    # muParser evaluates these: to 9, to 1.
    ("active stretch with a decimal comma", BLOCK, [FORMULA + "=0,9"],
     [f"'{FORMULA}'", "'0,9'", "a comma outside of a function",
      "Decimals have a point"]),
    ("active stretch that assigns", BLOCK, [FORMULA + "=if(t = 1, 0.9, 1)"],
     [f"'{FORMULA}'", "'=', which is no comparison", "'=='"]),
    ("active stretch that is two", BLOCK, [FORMULA + "=1; 0.9"],
     [f"'{FORMULA}'", "'1; 0.9'", "is not equal to the number"]),
    ("active stretch without a parenthesis", BLOCK, [FORMULA + "=sin(t"],
     [f"'{FORMULA}'", "'sin(t'", "Missing parenthesis", "It may use"]),
    ("active stretch of a function there is not", BLOCK,
     [FORMULA + "=step(t)"],
     [f"'{FORMULA}'", '"step"', "the functions of muParser"]),
    ("wave that shortens to nothing", BLOCK,
     another_muscle("set Fibres = radial\nset Active stretch = wave\n"
                    "subsection wave\nset Amplitude = 1\nend"),
     ["'Muscles/triceps/wave/Amplitude' is 1 for segment 1",
      "has to be less than 1"]),
    ("wave that pulls more than a muscle can", BLOCK,
     another_muscle("set Fibres = longitudinal\nset Action = active stress\n"
                    "set Activation = wave\n"
                    "subsection wave\nset Amplitude = 1.2\nend"),
     ["'Muscles/triceps/wave/Amplitude' is 1.2 for segment 1"]),
    ("pull without an activation", BLOCK,
     another_muscle("set Fibres = longitudinal\nset Action = active stress"),
     ["'Muscles/triceps/Activation' is not set", "no activation",
      "Set it to one of 'expression'"]),
    ("activation of more than one", BLOCK,
     pull("", formula="2*t"),
     ["activation of muscle 'triceps' in segment 1", "is 1.", "from 0 (rest) to 1",
      "'Muscles/triceps/expression'"]),
    ("activation that pushes", BLOCK, pull("", formula="-t"),
     ["activation of muscle 'triceps'", "from 0 (rest) to 1"]),
    ("strength that pushes", BLOCK, pull("set Strength = -0.25"),
     ["'Muscles/triceps/active stress/Strength' is -0.25 N/mm^2 at",
      "a number >= 0", "Muscle 'triceps'"]),
    ("strength that is no number", BLOCK, pull("set Strength = 1/(s - 1)"),
     ["'Muscles/triceps/active stress/Strength' is inf"]),
    ("strength that changes with time", BLOCK, pull("set Strength = 0.1*t"),
     ["'Muscles/triceps/active stress/Strength' is '0.1*t'", "the activation"]),
    ("tension of no kind", BLOCK, pull("set Kind = Cauchy"),
     ["'Muscles/triceps/active stress/Kind'", "'nominal', 'second Piola'"]),
    ("best length of zero", BLOCK, pull(
        "set Force-length = Blemker\nsubsection Blemker\nset Best length = 0\nend"),
     ["'Muscles/triceps/active stress/Blemker/Best length'", "> 0"]),
    ("curve without its file", BLOCK, pull("set Force-length = file"),
     ["'Muscles/triceps/active stress/file/File' is not set", "Give the path"]),
    ("curve whose file is not there", BLOCK, pull(
        "set Force-length = file\nsubsection file\nset File = no.csv\nend"),
     ["'Muscles/triceps/active stress/file/File'", "'no.csv' cannot be read"]),
    ("stretched fibre that is weaker", BLOCK, pull(
        "set Force-velocity = Hill\nsubsection Hill\nset Largest = 0.9\nend"),
     ["'Muscles/triceps/active stress/Hill/Largest' is 0.9", "more than 1"]),
    ("fastest of zero", BLOCK, pull(
        "set Force-velocity = Hill\nsubsection Hill\nset Fastest = 0\nend"),
     ["'Muscles/triceps/active stress/Hill/Fastest'", "> 0"]),
    ("growth without its formula", BLOCK,
     another_muscle("set Fibres = longitudinal\nset Action = growth"),
     ["'Muscles/triceps/Growth' is not set", "Set it to one of 'expression'"]),
    ("growth to nothing", BLOCK,
     another_muscle("set Fibres = longitudinal\nset Action = growth\n"
                    "set Growth = expression\nsubsection expression\n"
                    "set Formula = 1 - 2*t\nend"),
     ["growth of muscle 'triceps' in segment 1", "a number > 0", "a growth by 20%",
      "'Muscles/triceps/expression'"]),
    ("growth by a formula that does not parse", BLOCK,
     another_muscle("set Fibres = longitudinal\nset Action = growth along fibres\n"
                    "set Growth = expression\nsubsection expression\n"
                    "set Formula = sin(t\nend"),
     ["'Muscles/triceps/expression/Formula'", "'sin(t'", "Missing parenthesis"]),
    ("active stretch of a muscle that pulls", BLOCK,
     pull("").replace("set Activation", "set Active stretch"),
     ["'Muscles/triceps/Active stretch'", "is unknown"]),
    ("wave that lasts more than its period", BLOCK,
     another_muscle("set Fibres = radial\nset Active stretch = wave\n"
                    "subsection wave\nset Duty = 1.5\nend"),
     ["'Muscles/triceps/wave/Duty' is 1.5", "at most 1"]),
    ("fibres of no direction", BLOCK, fibres("direction", "Direction",
                                             "0, 0, 0"),
     ["'Muscles/biceps/direction/Direction'", "Give a vector like '1, 0, 0'"]),
    ("fibres that do not parse", BLOCK,
     fibres("vector expression", "Formulas", "1; q; 0"),
     ["'Muscles/biceps/vector expression/Formulas'", '"q"', "It may use"]),
    ("fibres of two components", BLOCK,
     fibres("vector expression", "Formulas", "1; 0"),
     ["'Muscles/biceps/vector expression/Formulas'", "2 components",
      "three expressions separated by semicolons"]),
    ("fibres that vanish somewhere", BLOCK,
     fibres("vector expression", "Formulas", "0; 0; 0"),
     ["'Muscles/biceps/vector expression/Formulas'", "no direction at the "
      "point", "Change the formulas"]),

    # Loads and supports.
    ("boundary there is not", BLOCK, ["Boundary conditions/push/Boundary=top"],
     ["'Boundary conditions/push/Boundary' is 'top'",
      "'x min', 'x max', 'y min', 'y max', 'z min', 'z max'"]),
    ("boundary that is cut away by symmetry", BLOCK,
     ["Geometry/block/Symmetry=x"],
     ["'Boundary conditions/wall/Boundary' is 'x min'", "Give one of 'x max'"]),
    ("no boundary", BLOCK, ["Boundary conditions/push/Boundary="],
     ["'Boundary conditions/push/Boundary' is ''", "Give one of 'x min'"]),
    ("no type", BLOCK, ["Boundary conditions/Names=wall, push, more"],
     ["'Boundary conditions/more/Type' is not set", "Set it to one of",
      "'displacement', 'drag', 'follower pressure'"]),
    ("pressure that does not parse", BLOCK, [PRESSURE + "=0.1*sin("],
     [f"'{PRESSURE}'", "'0.1*sin('", "It may use t, x, y, z, pi"]),
    ("traction that does not parse", BLOCK,
     load("dead traction", "Traction", "0; 2*p; 0"),
     ["'Boundary conditions/more/dead traction/Traction'", '"p"',
      "It may use t, x, y, z, pi"]),
    ("traction of one component", BLOCK,
     load("dead traction", "Traction", "t"),
     ["'Boundary conditions/more/dead traction/Traction'", "1 components",
      "three expressions separated by semicolons"]),
    ("displacement that does not parse", BLOCK,
     load("displacement", "Displacement", "0; 0.1 t; 0"),
     ["'Boundary conditions/more/displacement/Displacement'", "'0.1 t'",
      "It may use t, x, y, z, pi"]),
    ("springs that push", BLOCK, load("spring", "Stiffness", "-1"),
     ["'Boundary conditions/more/spring/Stiffness' is '-1'", "a number > 0"]),
    ("component there is not", BLOCK, load("displacement", "Components", "r"),
     ["'Boundary conditions/more/displacement/Components' is 'r'",
      "one of 'x', 'y', 'z'"]),
    ("pressure that is NaN late", BLOCK, [PRESSURE + "=sqrt(0.985 - t)"],
     [f"'{PRESSURE}'", "nan", "at time 0.99", "Change it"]),
    ("traction that is infinite on the boundary", BLOCK,
     load("dead traction", "Traction", "0; 1/(y - 1); 0"),
     ["'Boundary conditions/more/dead traction/Traction'", "inf",
      "at time 0", "Change it"]),
    ("displacement prescribed twice", BLOCK,
     load("displacement", "Components", "x").replace("y max", "x min"),
     ["'Boundary conditions/more'", "along x", "'x min'", "twice",
      "Remove one"]),
    ("body that can move", BLOCK,
     ["Boundary conditions/Minimal support=false",
      "Boundary conditions/wall/displacement/Components=x"],
     ["translation along y, translation along z, rotation about x",
      "Set 'Boundary conditions/Minimal support' to true"]),

    ("liquid that can spin", CHAIN,
     ["Interface/Coupling=slip", "Boundary conditions/Minimal support=false",
      "Geometry/segment chain/Cross-section=full"],
     ["can still move rigidly", "Set 'Boundary conditions/Minimal support' to "
      "true", "'displacement' or 'spring', or a 'contact' with friction, "
      "that holds it"]),

    # The file.
    ("empty file", PRM, "# Nothing yet.\n",
     ["case.prm' sets nothing", "Copy one of the gallery in parameters/"]),
    ("file that is no text", PRM, b"\x7fELF\x02\x01\x01\x00\x00set A = 1",
     ["case.prm' is not plain text", "UTF-8"]),
    ("file in UTF-16", PRM, "set Title = x\n".encode("utf-16"),
     ["case.prm' is not plain text", "UTF-8"]),
    ("subsection without end", BLOCK, "subsection Time\n  set End = 2\n",
     ["case.prm, line 2: 'subsection Time' has no 'end'", "for each of "
      "these, 'end'"]),
    ("inner subsection without end", BLOCK,
     "subsection Linear solver\n  subsection direct\nend\n",
     ["case.prm, line 2: 'subsection Linear solver' has no 'end'"]),
    ("end without subsection", BLOCK, "set Title = x\nend\n",
     ["case.prm, line 3: 'end' without a 'subsection'"]),
    ("line that is neither", BLOCK, "set Title = x\nTitle = y\n",
     ["case.prm, line 3: 'Title = y' is none", "'set Name = value'"]),
    ("long line that is neither", BLOCK, "Title = " + 1000 * "y",
     ["case.prm, line 2: 'Title = yyy", "y... (1008 characters)' is none"]),
    ("no equals sign", BLOCK, "set Title\n",
     ["case.prm, line 2: 'set Title' has no '='", "'set Name = value'"]),
    ("no name", BLOCK, "set = 1\n",
     ["case.prm, line 2: 'set = 1' has no name", "'set Name = value'"]),
    # deal.II's message: 'No entry with name <Time/End> was declared'.
    ("path of a parameter in a file", BLOCK, "set Time/End = 2\n",
     ["case.prm, line 2: 'set Time/End = 2' has a '/' in its name",
      "each part before a '/' is a 'subsection'"]),
    ("path of a section in a file", BLOCK, "subsection Time/x\nend\n",
     ["case.prm, line 2: 'subsection Time/x' has a '/'"]),
    ("include in quotation marks", PRM, 'include "base.prm"\n',
     ['"base.prm"', "cannot be read",
      "from the folder of the file that includes it"]),
    ("include of nothing", BLOCK, "include\n",
     ["case.prm, line 2: 'include' is none of the lines"]),

    # JSON.
    ("comma after the last entry of JSON", JSON, '{"Time": {"End": 1,}}',
     ["case.json, line 1: this is no JSON", "not after the last"]),
    ("comment in JSON", JSON, '{"Title": "x"} // y',
     ["case.json, line 1: this is no JSON", "there are no comments"]),
    ("empty JSON", JSON, "", ["case.json, line 1: this is no JSON"]),
    ("JSON that says nothing", JSON, "{}", ["case.json' sets nothing"]),
    ("list for an object of JSON", JSON, "[1, 2]",
     ["case.json: the file has to be one object", '{ "Section": {']),
    ("wrong type in JSON", JSON, '{"Time": {"End": true}}',
     ["case.json: the parameter 'Time/End' is 'true'", "a number > 0"]),
    ("nothing in JSON", JSON, '{"Time": {"End": null}}',
     ["case.json: the parameter 'Time/End' is 'null'", "a number > 0"]),
    ("list for a number of JSON", JSON, '{"Time": {"End": [1, 2]}}',
     ["case.json: the parameter 'Time/End' is '1, 2'", "a number > 0"]),
    ("list of lists in JSON", JSON, '{"Output": {"Points": [[0, 0, 0]]}}',
     ["case.json: the list 'Points' has a list", "Write lists of lists as "
      "text"]),
    ("number for a section of JSON", JSON, '{"Time": 3}',
     ["case.json: the parameter 'Time' is unknown: that is a section"]),
    ("section for a parameter of JSON", JSON, '{"Time": {"End": {"a": 1}}}',
     ["case.json: the section 'Time/End' is unknown: that is a parameter"]),
    # The last one won, as no other reader of JSON promises.
    ("name twice in JSON", JSON, '{"Time": {"End": 1, "End": 2}}',
     ["case.json: the name 'End' is there twice", "Leave one of them out"]),
    ("path for a name of JSON", JSON, '{"Time/End": 2}',
     ["case.json: 'Time/End' is no name", '{ "Section": { "Name": value } }']),
    # What followed the # was lost.
    ("comment in a text of JSON", JSON, '{"Title": "Case #1"}',
     ["case.json: 'Case #1' has a '#', which starts a comment",
      "Leave it out"]),
    ("line break in a text of JSON", JSON, '{"Title": "a\\nset Time = x"}',
     ["case.json: ", "has a line break", "Leave it out"]),
    ("backslash in a list of JSON", JSON, '{"Title": ["a", "b\\\\"]}',
     ["case.json: 'b\\' has a '\\' at its end", "Leave it out"]),

    # The command line.
    ("setting without a value", BLOCK, ["Time/End"],
     ["'Time/End'", '--set "Section/Name=value"']),
    ("setting without a name", BLOCK, ["=1"],
     ["'=1'", '--set "Section/Name=value"']),
    ("setting without a section", BLOCK, ["/End=1"],
     ["'/End=1' is not of the form", '--set "Section/Name=value"']),
    ("setting without a name in its section", BLOCK, ["Time/=1"],
     ["'Time/=1' is not of the form", '--set "Section/Name=value"']),
    # It was that of 'Time/End'.
    ("setting with a comment", BLOCK, ["Time#/End=1"],
     ["'Time#/End=1' has a '#', which starts a comment", "Leave it out"]),
    # It ended the section of the setting, not only its line.
    ("setting with a backslash at its end", BLOCK, ["Title=x\\"],
     ["has a '\\' at its end, with which a line goes on", "Leave it out"]),
    ("setting of two lines", BLOCK, ["Title=x\nset Units = y"],
     ["has a line break in parameter files", "Leave it out"]),
]


def start(mistake, ranks, folder, run):
    """Run with a mistake on some ranks, in a folder of its own."""
    _, base, change, _ = mistake
    settings = change if isinstance(change, list) else []
    folder.mkdir()
    if base in (PRM, JSON):
        case = folder / f"case{base}"
        case.write_bytes(change if isinstance(change, bytes) else
                         change.encode())
    else:
        case = folder / "case.prm"
        case.write_text(f"include {base}\n" +
                        (change if isinstance(change, str) else ""))
    return run(case, folder / "out", settings, ranks)


CASES = on_ranks(MISTAKES, on_two=[
    "misspelt parameter", "active stretch that does not parse",
    "active stretch of zero", "fibres that vanish somewhere",
    "body that can move", "point outside of the body", "empty file"])


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    return run_all(start, CASES, tmp_path_factory.mktemp("mistakes"))


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_one_message_names_the_parameter_and_the_way_out(i, results):
    (_, _, _, words), _ = CASES[i]
    check_one_message(results[i], words)
    assert results[i].log == ""


def test_expressions_are_tried_where_they_are_used(tmp_path):
    """Not a mistake: defined on its boundary and in its tissue only."""
    case = tmp_path / "case.prm"
    case.write_text(f"include {BLOCK}\n" +
                    load("dead traction", "Traction",
                         "0; 0*sqrt(y - 0.9); 0"))
    result = run(case, tmp_path / "out",
                 [PRESSURE + "=0.01*sqrt(x - 1.9)",
                  FORMULA + "=1 - 0.01*t*y/sqrt(y^2 + z^2)"])
    assert result.exit_code == 0, result.message


def test_the_bases_have_no_mistake(tmp_path):
    for base in (BLOCK, CHAIN):
        result = run(base, tmp_path / "out", options=["--check"])
        assert result.exit_code == 0, result.message
