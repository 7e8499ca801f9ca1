package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * Every joint, formulation, closure, force and motion, with events and outputs, is generated; what
 * data compute beside the code is named with its reason.
 */
class EverythingIsCodeTest {
  private static final List<Class<? extends ForceElement>> FORCES =
      List.of(
          SpringDamper.class,
          Bushing.class,
          Contact.class,
          PairForce.class,
          ForceTorque.class,
          JointSpringDamper.class,
          JointFriction.class,
          JointForce.class,
          CouplingSpringDamper.class,
          UserForceElement.class);

  /** Formulation and closure. */
  private enum Method {
    DTR("DTR", "none"),
    DSR("DSR", "none"),
    RR("RR", "none"),
    RR_JF("RR-JF", "none"),
    DSR_PROJECTION("DSR", "projection"),
    RR_PROJECTION("RR", "projection"),
    RR_JF_PROJECTION("RR-JF", "projection"),
    DSR_PENALTY("DSR", "penalty"),
    RR_PENALTY("RR", "penalty"),
    RR_JF_PENALTY("RR-JF", "penalty");

    private final String formulation;
    private final String closure;

    Method(String formulation, String closure) {
      this.formulation = formulation;
      this.closure = closure;
    }

    boolean isOpen() {
      return closure.equals("none");
    }

    BuildOptions options() {
      String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
      RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
      String closing = isOpen() ? "auto" : closure;
      return new BuildOptions(
          formulation, closing, false, EnumSet.allOf(ColumnGroup.class), settings);
    }
  }

  /** One of each kind. */
  private record Combination(
      JointType joint,
      Method method,
      Optional<RandomMechmlLoops.Kind> loop,
      Class<? extends ForceElement> force,
      boolean driven) {

    /** A joint of the type, a free body, and a hinge that may be driven; closed at its end. */
    Mechanism chain(long seed) {
      Random random = new Random(seed);
      RandomMechmlJoints joints = new RandomMechmlJoints(random);
      List<Joint> chain = new ArrayList<>();
      List<Body> bodies = new ArrayList<>();
      List<JointType> types = List.of(joint, JointType.F, JointType.R);
      for (int i = 0; i < types.size(); i++) {
        Vector3 cog = new Vector3(0.2, 0.1 * i, -0.1);
        InertiaTensor inertia = new InertiaTensor(1, 1.2, 1.5, 0.1, 0, 0);
        bodies.add(new Body("b" + i, 1 + i, cog, inertia, Origin.NONE));
        Vector3 place = new Vector3(0.5, 0.2, 0.1 * i);
        Attachment at = new Attachment(i - 1, place, i, new Vector3(0, 0.1, 0), Rotation.IDENTITY);
        chain.add(joints.of(types.get(i), "j" + i, at, new Vector3(0.2, 0.1, 1)));
      }
      List<PrescribedMotion> motions =
          driven ? List.of(new PrescribedMotion(2, List.of(joints.ofTime()))) : List.of();
      Mechanism free =
          new Mechanism(
              "chain",
              new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
              new Vector3(0, 0, -9.81),
              bodies,
              chain,
              motions,
              Collections.nCopies(chain.size(), StartRole.PREFERRED),
              List.of(),
              List.of(),
              List.of());
      return RandomMechmlForces.of(force, free, seed);
    }

    /** Returns the first one whose loop can be closed at the start. */
    MechmlModel model(long seed) {
      Mechanism closed =
          LongStream.iterate(seed, other -> other + 1)
              .mapToObj(this::closed)
              .filter(LoopAgreement::closes)
              .findFirst()
              .orElseThrow();
      Mechanism forced =
          force.equals(UserForceElement.class) ? GeneratedUserForcesTest.pulled(closed) : closed;
      return RandomMechmlEvents.on(forced, seed);
    }

    private Mechanism closed(long seed) {
      Mechanism chain = chain(seed);
      return loop.map(kind -> RandomMechmlLoops.closedBy(kind, chain, seed)).orElse(chain);
    }

    /** Returns the groups of columns that data compute beside the code. */
    Set<String> fromData(Mechanism mechanism) {
      Set<String> groups = new TreeSet<>(Set.of("reactions", "momentum"));
      if (loop.isPresent()) {
        groups.add("constraints");
      }
      if (loop.isPresent() || force.equals(UserForceElement.class)) {
        groups.add("forces");
      }
      boolean cutIsDriven =
          mechanism.closures().stream()
              .anyMatch(closure -> closure instanceof JointClosure cut && !cut.motion().isEmpty());
      if (driven || cutIsDriven) {
        groups.add("drives");
      }
      return groups;
    }
  }

  private static void assertIsCode(Combination combination, long seed) {
    MechmlModel file = combination.model(seed);
    GeneratedModel generated = ModelFactory.generate(file, combination.method().options());
    assertThat(generated.formulationReason()).as("%s", combination).doesNotContain("compact form");
    assertThat(generated.fromData())
        .as("%s", combination)
        .allSatisfy(part -> assertThat(part.why()).isNotEmpty())
        .extracting(Omission::what)
        .containsExactlyInAnyOrderElementsOf(combination.fromData(file.mechanism()));
    ClassLoader users = GeneratedUserForcesTest.class.getClassLoader();
    Model model = GeneratedUserForcesTest.loaded(generated, new TreeMap<>(), users);
    assertThat(model.description().formulation()).isEqualTo(combination.method().formulation);
  }

  /** Motions, forces and closures take turns, so that each meets each joint and each method. */
  @ParameterizedTest
  @EnumSource(JointType.class)
  void whateverIsCombinedWithAJoint(JointType joint) {
    int turn = List.of(JointType.values()).indexOf(joint);
    for (Method method : Method.values()) {
      RandomMechmlLoops.Kind[] kinds = RandomMechmlLoops.Kind.values();
      Optional<RandomMechmlLoops.Kind> loop =
          method.isOpen() ? Optional.empty() : Optional.of(kinds[turn % kinds.length]);
      Class<? extends ForceElement> force = FORCES.get(turn % FORCES.size());
      assertIsCode(new Combination(joint, method, loop, force, turn % 3 == 0), turn);
      turn++;
    }
  }

  @Test
  @Tag("soak")
  void everyCombination() {
    int seed = 0;
    for (JointType joint : JointType.values()) {
      for (Method method : Method.values()) {
        for (Class<? extends ForceElement> force : FORCES) {
          for (boolean driven : new boolean[] {false, true}) {
            for (Optional<RandomMechmlLoops.Kind> loop : closures(method)) {
              assertIsCode(new Combination(joint, method, loop, force, driven), seed++);
            }
          }
        }
      }
    }
  }

  private static List<Optional<RandomMechmlLoops.Kind>> closures(Method method) {
    List<Optional<RandomMechmlLoops.Kind>> closures = new ArrayList<>();
    if (method.isOpen()) {
      closures.add(Optional.empty());
    } else {
      for (RandomMechmlLoops.Kind kind : RandomMechmlLoops.Kind.values()) {
        closures.add(Optional.of(kind));
      }
    }
    return closures;
  }
}
