package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.spatial.Vector3;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** What the class of a model has and calls: read from its code, nothing that its scene lacks. */
class NothingUnneededTest {
  private static final String PENDULUM = "pendulum/pendulum.xml";
  private static final String DRIVER = "driver/driver-free-c0.xml";
  private static final String SUSPENSION = "five-point-suspension/variants/elements.xml";
  private static final double GRAVITY = 9.81;

  /** What a class has and calls, and the numbers in it. */
  private static final class Inventory extends ClassVisitor {
    private final Set<String> methods = new TreeSet<>();
    private final Set<String> fields = new TreeSet<>();
    private final Set<String> calls = new TreeSet<>();
    private final Set<Double> numbers = new TreeSet<>();
    private final Set<String> interfaces = new TreeSet<>();
    private String base = "";

    Inventory() {
      super(Opcodes.ASM9);
    }

    @Override
    public void visit(
        int version, int access, String name, String generic, String parent, String[] types) {
      base = parent;
      for (String type : types) {
        interfaces.add(simple(type));
      }
    }

    @Override
    public FieldVisitor visitField(
        int access, String name, String type, String generic, Object value) {
      fields.add(name);
      return super.visitField(access, name, type, generic, value);
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String type, String generic, String[] thrown) {
      methods.add(name.replaceAll("\\d+$", ""));
      return new MethodVisitor(Opcodes.ASM9) {
        @Override
        public void visitMethodInsn(
            int code, String owner, String called, String type, boolean inInterface) {
          if (!owner.startsWith("org/mechservice/model/")) {
            calls.add(simple(owner) + "." + called);
          }
        }

        @Override
        public void visitLdcInsn(Object value) {
          if (value instanceof Double number) {
            numbers.add(Math.abs(number));
          }
        }
      };
    }

    private static String simple(String type) {
      return type.substring(type.lastIndexOf('/') + 1);
    }
  }

  private static MechmlModel example(String file) throws Exception {
    Path path = Path.of("..", "..", "examples").resolve(file);
    return MechmlReader.read(path.getFileName().toString(), Files.readAllBytes(path));
  }

  private static Inventory inventory(MechmlModel model, String formulation) {
    BuildOptions options =
        new BuildOptions(
            formulation,
            "auto",
            false,
            Set.of(ColumnGroup.ENERGY),
            new RunSettings(0, 1, 0.01, "DE", 1e-5, 1e-5));
    GeneratedModel generated = ModelFactory.generate(model, options);
    Inventory inventory = new Inventory();
    byte[] file = Objects.requireNonNull(generated.classFiles().get(generated.className()));
    new ClassReader(file).accept(inventory, 0);
    assertThat(generated.classFiles()).hasSize(1);
    return inventory;
  }

  @Test
  void thePendulumsClassHasTheEquationsOfTurningJointsAndNothingElse() throws Exception {
    Inventory pendulum = inventory(example(PENDULUM), "DTR");
    assertThat(pendulum.base).isEqualTo("java/lang/Object");
    assertThat(pendulum.interfaces).containsExactlyInAnyOrder("ExplicitModel", "Energies");
    assertThat(pendulum.methods)
        .containsExactlyInAnyOrder("<init>", "description", "initialState", "derivative", "energy");
    assertThat(pendulum.fields).containsExactly("w");
    assertThat(pendulum.calls)
        .containsExactlyInAnyOrder(
            "Object.<init>",
            "ModelDescription.of",
            "RunSettings.<init>",
            "Arrays.fill",
            "System.arraycopy",
            "SinCos.sinCos");
  }

  @Test
  void theDriversClassHasNoMoreThanThePendulumsBesidesItsParts() throws Exception {
    Inventory pendulum = inventory(example(PENDULUM), "DTR");
    Inventory driver = inventory(example(DRIVER), "DTR");
    assertThat(driver.interfaces).isEqualTo(pendulum.interfaces);
    assertThat(driver.methods).isEqualTo(pendulum.methods);
    assertThat(driver.fields).isEqualTo(pendulum.fields);
    assertThat(pendulum.calls).containsAll(driver.calls);
  }

  @Test
  void compositeInertiasAddNoMethodAndNoCall() throws Exception {
    Inventory recursive = inventory(example(PENDULUM), "DTR");
    Inventory composite = inventory(example(PENDULUM), "DSR");
    assertThat(composite.methods).isEqualTo(recursive.methods);
    assertThat(recursive.calls).containsAll(composite.calls);
  }

  /** Gravity is there as a number: products with it are folded into others. */
  @Test
  void withoutGravityNoNumberComesFromIt() throws Exception {
    Inventory heavy = inventory(example(PENDULUM), "DTR");
    Inventory light = inventory(Scenes.model(weightless(example(PENDULUM).mechanism())), "DTR");
    assertThat(heavy.numbers).contains(GRAVITY);
    assertThat(light.numbers).doesNotContain(GRAVITY);
    assertThat(light.numbers.size()).isLessThan(heavy.numbers.size());
  }

  /** The parameter is there to be set; the equations do not have it. */
  @Test
  void aClassThatReadsNoParameterIsGivenNone() throws Exception {
    Mechanism pendulum = example(PENDULUM).mechanism();
    Mechanism tuned =
        new Mechanism(
            pendulum.name(),
            pendulum.root(),
            pendulum.gravity(),
            pendulum.bodies(),
            pendulum.joints(),
            pendulum.motions(),
            pendulum.startRoles(),
            List.of(),
            List.of(),
            List.of(new Parameter("k", 1, "1")));
    BuildOptions options = new BuildOptions("DTR", Set.of(), Scenes.SETTINGS);
    MechmlModel model = Scenes.model(tuned);
    CompiledModel compiled =
        ModelFactory.compile(model, options, ModelFactory.generate(model, options));
    Inventory inventory = new Inventory();
    String equations = compiled.generated().sourceName();
    new ClassReader(Objects.requireNonNull(compiled.classFiles().get(equations)))
        .accept(inventory, 0);
    assertThat(inventory.fields).containsExactly("w");
    assertThat(compiled.classes().describing().parameters()).hasSize(1);
    assertThat(compiled.newInstance().description().name()).isEqualTo(pendulum.name());
  }

  private static Mechanism weightless(Mechanism m) {
    return new Mechanism(m.name(), m.root(), Vector3.ZERO, m.bodies(), m.joints());
  }

  /** In compact form a class is its data: the solver has the equations. */
  @Test
  void theCompactSuspensionIsDataAlone() throws Exception {
    BuildOptions options =
        new BuildOptions(
            "DSR",
            "auto",
            true,
            Set.of(ColumnGroup.ENERGY),
            new RunSettings(0, 1, 0.01, "DE", 1e-5, 1e-5));
    GeneratedModel generated = ModelFactory.generate(example(SUSPENSION), options);
    Inventory inventory = new Inventory();
    byte[] file = Objects.requireNonNull(generated.classFiles().get(generated.className()));
    new ClassReader(file).accept(inventory, 0);
    assertThat(inventory.base).isEqualTo("org/mechservice/solver/compact/CompactSource");
    assertThat(inventory.methods).containsExactlyInAnyOrder("<init>", "bare", "texts");
    assertThat(inventory.calls)
        .containsExactlyInAnyOrder("CompactSource.<init>", "DataDrivenLoops.model");
    assertThat(inventory.numbers).isEmpty();
    assertThat(inventory.fields).isEmpty();
  }
}
