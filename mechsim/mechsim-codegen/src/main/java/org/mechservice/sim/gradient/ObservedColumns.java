package org.mechservice.sim.gradient;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.sim.emit.ModelClass;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.sim.equations.PoseEquations;
import org.mechservice.sim.equations.PowerEquations;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * Columns of results as functions of state, derivative of the state and time: coordinates,
 * velocities and accelerations of joints, states of the model, positions and velocities of bodies,
 * energies, and the outputs of the file.
 */
final class ObservedColumns {
  private static final String[] POSE = {
    ".x", ".y", ".z", "", "", "", "", ".vx", ".vy", ".vz", ".wx", ".wy", ".wz"
  };

  private static final String[] POSE_UNITS = {
    "m", "m", "m", "", "", "", "", "m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s"
  };

  /**
   * The origin of a column.
   *
   * @param unit its SI unit
   * @param kind which program
   * @param index which of its outputs, or which input
   */
  private record Origin(String unit, Kind kind, int index) {}

  private enum Kind {
    INPUT,
    OUTPUT,
    ENERGY,
    POSE
  }

  private final MechmlModel model;
  private final Mechanism mechanism;
  private final Map<String, Origin> known = new LinkedHashMap<>();

  ObservedColumns(MechmlModel model) {
    this.model = model;
    this.mechanism = model.mechanism();
    ModelDescription description =
        new ModelDescription(
            mechanism.name(),
            "",
            ModelClass.joints(mechanism),
            mechanism.stateVariables(),
            model.settings().run());
    int n = mechanism.stateCount();
    List<Variable> states = description.states();
    for (int i = 0; i < states.size(); i++) {
      known.put(states.get(i).name(), new Origin(states.get(i).unit(), Kind.INPUT, i));
    }
    List<Variable> rates = description.accelerations();
    for (int i = 0; i < rates.size(); i++) {
      int at = n + mechanism.positionCount() + i;
      known.put(rates.get(i).name(), new Origin(rates.get(i).unit(), Kind.INPUT, at));
    }
    List<Output> outputs = model.outputs();
    for (int i = 0; i < outputs.size(); i++) {
      known.put(outputs.get(i).name(), new Origin(outputs.get(i).unit(), Kind.OUTPUT, i));
    }
    known.put("energy.kinetic", new Origin("J", Kind.ENERGY, 0));
    known.put("energy.potential", new Origin("J", Kind.ENERGY, 1));
    for (int b = 0; b < mechanism.bodies().size(); b++) {
      for (int i = 0; i < POSE.length; i++) {
        if (!POSE[i].isEmpty()) {
          known.put(
              mechanism.bodies().get(b).name() + POSE[i],
              new Origin(POSE_UNITS[i], Kind.POSE, BodyPoses.NUMBERS_PER_BODY * b + i));
        }
      }
    }
  }

  /**
   * Returns the SI unit of a column.
   *
   * @throws IllegalArgumentException if there is no such column, or no derivative of it
   */
  String unit(String column) {
    return origin(column).unit();
  }

  private Origin origin(String column) {
    Origin origin = known.get(column);
    if (origin == null) {
      List<String> names = List.copyOf(known.keySet());
      throw new IllegalArgumentException(
          "gradients know no column \""
              + column
              + '"'
              + NearestName.suggestion(column, names)
              + "; they know coordinates (.q, .v, .a) of the model's joints that are not driven,"
              + " its states, energy.kinetic, energy.potential, places and velocities of bodies (.x"
              + " to .wz), and its outputs; write an <output> for what is none of these");
    }
    return origin;
  }

  /** Returns the names of the components of the state. */
  List<String> stateNames() {
    return known.keySet().stream().filter(name -> state(name).isPresent()).toList();
  }

  /** Returns the SI units of the components of the state. */
  List<String> stateUnits() {
    return stateNames().stream().map(this::unit).toList();
  }

  /** Returns which component of the state a column is; empty if it is none. */
  Optional<Integer> state(String column) {
    return Optional.ofNullable(known.get(column))
        .filter(origin -> origin.kind() == Kind.INPUT && origin.index() < mechanism.stateCount())
        .map(Origin::index);
  }

  /**
   * Returns the program of columns.
   *
   * @return from [y; y'] to the columns in their order
   */
  Program program(List<String> columns) {
    Program program = new Program();
    Links links = Links.of(mechanism);
    Map<Kind, Map<Integer, Scalar>> copies = new LinkedHashMap<>();
    List<Scalar> values = new ArrayList<>();
    for (String column : columns) {
      Origin origin = origin(column);
      if (origin.kind() == Kind.INPUT) {
        values.add(program.expressions().input(origin.index()));
      } else {
        values.add(
            copies
                .computeIfAbsent(
                    origin.kind(), kind -> copied(of(kind, links), program.expressions()))
                .getOrDefault(origin.index(), program.expressions().zero()));
      }
    }
    program.section("Columns.", "columns");
    for (int i = 0; i < values.size(); i++) {
      program.output(i, values.get(i));
    }
    return program;
  }

  private Program of(Kind kind, Links links) {
    return switch (kind) {
      case OUTPUT ->
          PowerEquations.formulas(links, model.outputs().stream().map(Output::value).toList());
      case ENERGY -> EnergyEquations.derive(links);
      case POSE -> PoseEquations.derive(links);
      case INPUT -> throw new IllegalArgumentException("an input is no program");
    };
  }

  /** Copies the outputs of a program into another graph. */
  private static Map<Integer, Scalar> copied(Program from, Expressions into) {
    GraphCopy copy = new GraphCopy(into);
    Map<Integer, Scalar> outputs = new TreeMap<>();
    for (Program.Section section : from.sections()) {
      section.outputs().forEach(o -> outputs.put(o.index(), copy.of(o.value())));
    }
    return outputs;
  }
}
