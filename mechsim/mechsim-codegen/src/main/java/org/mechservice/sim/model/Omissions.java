package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * Lists the parts that a generated class does not contain, each with the reason: the scene does not
 * need it, or the model computes it from data.
 */
final class Omissions {
  /** Longest list of names in a reason; a longer one is replaced by its number of names. */
  private static final int MOST_NAMES = 5;

  private static final String ONCE_A_ROW =
      "one sweep over the mechanism gives them once for each row of results";

  private final List<Omission> omissions = new ArrayList<>();

  /** Subject of reasons about joints; cut joints need no code for their coordinates. */
  private final String joint;

  private Omissions(Mechanism mechanism) {
    joint = mechanism.closures().isEmpty() ? "no joint" : "no joint of the tree";
  }

  /**
   * Lists the parts that the scene does not need.
   *
   * @param model the model file
   * @param links its mechanism in computing frames
   * @param options options of the build
   * @param derivative its equations
   */
  static List<Omission> unneeded(
      MechmlModel model, Links links, BuildOptions options, Program derivative) {
    Omissions leftOut = new Omissions(links.mechanism());
    leftOut.language(links.mechanism(), links);
    leftOut.rotations(links, options, derivative);
    leftOut.author(model);
    leftOut.scene(links.mechanism());
    leftOut.frames(links);
    if (links.mechanism().closures().isEmpty()) {
      leftOut.equations(derivative);
    }
    leftOut.outputs(options);
    return List.copyOf(leftOut.omissions);
  }

  /**
   * Lists the parts that the model computes from data in addition to its code.
   *
   * @param further groups of columns computed from data
   * @param values reason why events and outputs are not code; empty if they are
   * @param derivatives reason why derivatives of the residual are not code; empty if they are code
   *     or the formulation has none
   */
  static List<Omission> fromData(
      MechmlModel model,
      Set<ColumnGroup> further,
      Optional<String> values,
      Optional<String> derivatives) {
    List<Omission> all = new ArrayList<>();
    derivatives.ifPresent(why -> all.add(new Omission("derivatives of the residual", why)));
    Mechanism watched = model.watchedMechanism();
    if (!watched.events().isEmpty() || !watched.samplings().isEmpty()) {
      values.ifPresent(why -> all.add(new Omission("events", why)));
    }
    for (ColumnGroup group : further) {
      Optional<String> why = group == ColumnGroup.OUTPUTS ? values : Optional.of(ONCE_A_ROW);
      why.ifPresent(reason -> all.add(new Omission(group.label(), reason)));
    }
    return all;
  }

  /** Returns the omissions as a sentence. */
  static String sentence(List<Omission> omissions) {
    return omissions.stream()
        .map(omission -> omission.what() + " (" + omission.why() + ")")
        .collect(Collectors.joining("; ", "Left out: ", "."));
  }

  private void add(String what, String why) {
    omissions.add(new Omission(what, why));
  }

  private void language(Mechanism mechanism, Links links) {
    if (mechanism.closures().isEmpty()) {
      add("loop closures and constraints", "the joints form a tree");
    }
    if (!moves(links, LinkKind.SLIDE)) {
      add("sliding joints", joint + " slides");
    }
    boolean drivenCut =
        mechanism.closures().stream()
            .anyMatch(closure -> closure instanceof JointClosure cut && cut.isDriven());
    if (mechanism.motions().isEmpty() && !drivenCut) {
      add("prescribed motions", "no joint is driven");
    }
    if (mechanism.forces().isEmpty()) {
      add("force elements", "the scene has no forces but gravity");
    }
  }

  /** Lists omitted rotations. Poses always contain quaternions, and formulas may contain sines. */
  private void rotations(Links links, BuildOptions options, Program derivative) {
    if (!moves(links, LinkKind.BALL) && !options.columns().contains(ColumnGroup.BODIES)) {
      add("quaternions", joint + " is spherical or free");
    }
    boolean turns = moves(links, LinkKind.TURN) || moves(links, LinkKind.SCREW);
    if (!turns && !hasAngles(derivative)) {
      add("sines and cosines", joint + " turns");
    }
  }

  private static boolean hasAngles(Program program) {
    int[] uses = program.uses();
    for (int id = 0; id < uses.length; id++) {
      Scalar node = program.expressions().node(id);
      boolean angle =
          switch (node.operation()) {
            case SINE, COSINE -> true;
            case FUNCTION ->
                node.function() == MathFunction.SIN || node.function() == MathFunction.COS;
            default -> false;
          };
      if (angle && uses[id] > 0) {
        return true;
      }
    }
    return false;
  }

  private void author(MechmlModel model) {
    Mechanism watched = model.watchedMechanism();
    if (watched.events().isEmpty() && watched.samplings().isEmpty()) {
      add("events", "the scene has none");
    }
    if (model.outputs().isEmpty()) {
      add("outputs of its own", "the scene has none");
    }
  }

  private static boolean moves(Links links, LinkKind kind) {
    for (Link link : links.links()) {
      if (link.kind() == kind) {
        return true;
      }
    }
    return false;
  }

  private void scene(Mechanism mechanism) {
    Vector3 g = mechanism.gravity();
    if (g.x() == 0 && g.y() == 0 && g.z() == 0) {
      add("gravity", "it is zero");
    }
    if (mechanism.root().orientation().isIdentity()) {
      add("orientation of the root", "its axes are the world's");
    }
    List<String> names = new ArrayList<>();
    for (Body body : mechanism.bodies()) {
      if (body.isMassless()) {
        names.add(body.name());
      }
    }
    if (!names.isEmpty()) {
      boolean few = names.size() <= MOST_NAMES;
      add(
          "inertia of " + (few ? "bodies " + String.join(", ", names) : names.size() + " bodies"),
          "they have neither mass nor inertia");
    }
  }

  private void frames(Links links) {
    int welded = 0;
    for (Joint joint : links.mechanism().joints()) {
      welded += joint.type() == JointType.W ? 1 : 0;
    }
    if (welded > 0) {
      add(welded + " welded bodies", "each is one with what it is welded to");
    }
    int spared = 0;
    for (Link link : links.links()) {
      spared += link.hasConstantTurn() ? 0 : 1;
    }
    if (spared > 0) {
      add(
          "constant rotations at " + spared + " of " + links.links().size() + " joints",
          "computing frames were chosen whose axes only change places there");
    }
  }

  private void equations(Program derivative) {
    boolean guarded = false;
    for (Program.Section section : derivative.sections()) {
      guarded |= !section.guards().isEmpty();
    }
    if (!guarded) {
      add("test for singular joints", "every body has inertia along its own joint");
    }
  }

  private void outputs(BuildOptions options) {
    if (!options.columns().contains(ColumnGroup.BODIES)) {
      add("poses of the bodies", "the column group \"bodies\" was not asked for");
    }
  }
}
