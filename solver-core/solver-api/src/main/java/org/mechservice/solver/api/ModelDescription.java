package org.mechservice.solver.api;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunSettings;

/**
 * The description of a model. The state is y = [q; v; s]: positions and velocities of the joints,
 * then the further states.
 *
 * @param name the model's name in its file
 * @param formulation the formulation of its equations, such as {@code DTR}
 * @param joints the joints that have states, in state order
 * @param furtherStates the states besides positions and velocities, in state order
 * @param defaults the settings of the model's file
 */
public record ModelDescription(
    String name,
    String formulation,
    List<JointVariables> joints,
    List<StateVariable> furtherStates,
    RunSettings defaults) {

  public ModelDescription {
    joints = List.copyOf(joints);
    furtherStates = List.copyOf(furtherStates);
  }

  /** Describes a model whose states are positions and velocities. */
  public ModelDescription(
      String name, String formulation, List<JointVariables> joints, RunSettings defaults) {
    this(name, formulation, joints, List.of(), defaults);
  }

  /**
   * Describes a model from the compact form that generated classes carry.
   *
   * @param types one {@link JointType} name per joint, separated by blanks
   * @param names the joints' names, separated by line feeds
   */
  public static ModelDescription of(
      String name, String formulation, String types, String names, RunSettings defaults) {
    List<JointVariables> joints = new ArrayList<>();
    if (!types.isEmpty()) {
      String[] typeOf = types.split(" ", -1);
      String[] nameOf = names.split("\n", -1);
      for (int i = 0; i < typeOf.length; i++) {
        joints.add(new JointVariables(nameOf[i], JointType.valueOf(typeOf[i])));
      }
    }
    return new ModelDescription(name, formulation, joints, defaults);
  }

  /**
   * Returns the same description with further states.
   *
   * @param names one per state, separated by line feeds
   * @param units their units, likewise
   * @param tolerances their tolerances as {@link StateVariable} takes them, likewise
   */
  public ModelDescription withFurtherStates(String names, String units, String tolerances) {
    String[] nameOf = names.split("\n", -1);
    String[] unitOf = units.split("\n", -1);
    String[] toleranceOf = tolerances.split("\n", -1);
    List<StateVariable> further = new ArrayList<>();
    for (int i = 0; i < nameOf.length; i++) {
      further.add(new StateVariable(nameOf[i], unitOf[i], Double.parseDouble(toleranceOf[i])));
    }
    return new ModelDescription(name, formulation, joints, further, defaults);
  }

  /** Returns the number of positions, nq. */
  public int positionCount() {
    return joints.stream().mapToInt(joint -> joint.type().positionCount()).sum();
  }

  /** Returns the number of velocities, nv. */
  public int velocityCount() {
    return joints.stream().mapToInt(joint -> joint.type().velocityCount()).sum();
  }

  /** Returns the length of the state y = [q; v; s]. */
  public int stateCount() {
    return positionCount() + velocityCount() + furtherStates.size();
  }

  /** Returns name and unit of every component of the state, q first, further states last. */
  public List<Variable> states() {
    List<Variable> states = new ArrayList<>();
    for (JointVariables joint : joints) {
      int count = joint.type().positionCount();
      for (int i = 0; i < count; i++) {
        states.add(new Variable(component(joint, ".q", i, count), joint.type().positionUnit(i)));
      }
    }
    for (JointVariables joint : joints) {
      int count = joint.type().velocityCount();
      for (int i = 0; i < count; i++) {
        states.add(new Variable(component(joint, ".v", i, count), joint.type().velocityUnit(i)));
      }
    }
    furtherStates.forEach(state -> states.add(state.variable()));
    return states;
  }

  /** Returns name and unit of every joint acceleration, in the order of v. */
  public List<Variable> accelerations() {
    List<Variable> accelerations = new ArrayList<>();
    for (JointVariables joint : joints) {
      int count = joint.type().velocityCount();
      for (int i = 0; i < count; i++) {
        String unit = joint.type().velocityUnit(i).replace("/s", "/s^2");
        accelerations.add(new Variable(component(joint, ".a", i, count), unit));
      }
    }
    return accelerations;
  }

  private static String component(JointVariables joint, String kind, int index, int count) {
    return joint.name() + kind + (count == 1 ? "" : "[" + index + "]");
  }
}
