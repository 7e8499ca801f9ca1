package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.MechmlReader;

/** A model built in code is the model of the same file, and is refused with the same words. */
class MechanismBuilderTest {
  private static final String DOUBLE_PENDULUM =
      """
      <?xml version="1.0"?>
      <!DOCTYPE MechML SYSTEM "mechml.dtd">
      <MechML>
        <MBSsimulation>
          <dynamic>
            <timeSet tini="0" tend="2" tstep="0.1"/>
            <integrator name="ode113" relTol="1e-8" absTol="1e-10"/>
            <output columns="joints;energy"/>
          </dynamic>
        </MBSsimulation>
        <MBSmodel name="DoublePendulum" massUnits="kg" lengthUnits="m">
          <Parameters>
            <parameter name="stiffness" value="20" unit="N/m"/>
          </Parameters>
          <Bodies>
            <body name="ground">
              <point name="o" x="0" y="0" z="0"/>
              <point name="anchor" x="0.5" y="0" z="0"/>
              <vector name="y" vx="0" vy="1" vz="0"/>
            </body>
            <body name="upper">
              <point name="top" x="0" y="0" z="0.5"/>
              <point name="end" x="0" y="0" z="-0.5"/>
              <vector name="y" vx="0" vy="1" vz="0"/>
              <cog x="0" y="0" z="0"/>
              <mass value="1200" unit="g"/>
              <inertiaTensor Ixx="0.1" Iyy="0.1" Izz="0.001"/>
            </body>
            <body name="lower">
              <point name="top" x="0" y="0" z="0"/>
              <point name="end" x="0" y="0" z="-1"/>
              <vector name="y" vx="0" vy="1" vz="0"/>
              <cylinder radius="0.02" from="top" to="end" mass="0.7"/>
            </body>
          </Bodies>
          <Joints>
            <joint name="shoulder" type="R">
              <body1 name="ground" point="o" vector="y"/>
              <body2 name="upper" point="top" vector="y"/>
            </joint>
            <joint name="elbow" type="R" damping="0.01">
              <body1 name="upper" point="end" vector="y"/>
              <body2 name="lower" point="top" vector="y"/>
            </joint>
          </Joints>
          <Forces>
            <springDamper name="spring" k="stiffness" length0="400" length0Unit="mm">
              <body1 name="ground" point="anchor"/>
              <body2 name="lower" point="end"/>
            </springDamper>
            <gravity gx="0" gy="0" gz="-9.81"/>
          </Forces>
          <topology>
            <root name="ground"/>
            <relCoorVals>
              <jointVal name="shoulder" posVals="0.3" velVals="0"/>
            </relCoorVals>
          </topology>
        </MBSmodel>
      </MechML>
      """;

  @TempDir private Path folder = Path.of("");

  /** In another order than the file's, on purpose. */
  private static MechanismBuilder doublePendulum() {
    MechanismBuilder model = MechanismBuilder.of("DoublePendulum");
    model.root("ground").point("o", 0, 0, 0).point("anchor", 0.5, 0, 0).vector("y", 0, 1, 0);
    model
        .body("upper")
        .inertia(0.1, 0.1, 0.001)
        .mass(1200, "g")
        .center(0, 0, 0)
        .point("top", 0, 0, 0.5)
        .point("end", 0, 0, -0.5)
        .vector("y", 0, 1, 0);
    BodyElement lower = model.body("lower");
    lower.cylinder(0.02, "top", "end").set("mass", 0.7);
    lower.point("top", 0, 0, 0).point("end", 0, 0, -1).vector("y", 0, 1, 0);
    model.start("shoulder", 0.3, 0);
    model
        .springDamper("spring")
        .set("k", "stiffness")
        .set("length0", 400, "mm")
        .between("ground", "anchor", "lower", "end");
    model.gravity(0, 0, -9.81);
    model.joint("shoulder", "R").between("ground", "o", "upper", "top").vectors("y", "y");
    model
        .joint("elbow", "R")
        .set("damping", 0.01)
        .between("upper", "end", "lower", "top")
        .vectors("y", "y");
    model.parameter("stiffness", 20, "N/m");
    model.dynamic(2, 0.1).columns("joints", "energy").integrator("ode113", 1e-8, 1e-10);
    return model;
  }

  @Test
  void doublePendulumInCodeIsThatOfTheFileToTheBit() throws Exception {
    MechModel read = MechModel.of("pendulum.xml", DOUBLE_PENDULUM);
    MechModel built = doublePendulum().model();
    assertThat(built.content().mechanism().name()).isEqualTo(read.content().mechanism().name());
    assertThat(rows(built, "built.csv")).hasSameBinaryContentAs(rows(read, "read.csv"));
  }

  private Path rows(MechModel model, String name) throws Exception {
    Path csv = folder.resolve(name);
    assertThat(model.simulate(csv).steps()).isPositive();
    return csv;
  }

  @Test
  void textIsCanonicalAndComesBackFromItsModel() throws Exception {
    String text = doublePendulum().mechml();
    Document again = MechmlReader.document("again.xml", text.getBytes(StandardCharsets.UTF_8));
    assertThat(DocumentWriter.write(again)).isEqualTo(text);
    Path file = folder.resolve("pendulum.xml");
    assertThat(doublePendulum().writeMechml(file).name()).isEqualTo("DoublePendulum");
    assertThat(file).hasContent(text);
    assertThat(elements(again)).isEqualTo(elements(document(DOUBLE_PENDULUM)));
  }

  private static Document document(String text) throws MechmlException {
    return MechmlReader.document("file.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Elements with their attributes; neither the order of these has a meaning nor where they are.
   */
  private static List<String> elements(Document document) {
    return elements(document.root()).toList();
  }

  private static Stream<String> elements(Element element) {
    Map<String, String> attributes = new TreeMap<>();
    for (Attribute attribute : element.attributes()) {
      attributes.put(attribute.name(), attribute.value());
    }
    return Stream.concat(
        Stream.of(element.name() + attributes),
        element.children().stream().flatMap(MechanismBuilderTest::elements));
  }

  /** All but the one that holds the text of another file, which is put there by the reader. */
  static List<Path> files() throws Exception {
    try (Stream<Path> files = Files.list(Path.of("../examples/elements"))) {
      return files
          .filter(file -> file.toString().endsWith(".xml") && !file.endsWith("included.xml"))
          .sorted()
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource("files")
  void everyExampleOfTheLanguageIsBuiltByTheNamesOfItsElements(Path file) throws Exception {
    Element root = document(Files.readString(file)).root();
    Element model = root.requiredChild("MBSmodel");
    MechanismBuilder builder =
        MechanismBuilder.of(
            model.required("name"), model.required("massUnits"), model.required("lengthUnits"));
    copyAttributes(model, builder);
    for (Element simulation : root.children("MBSsimulation")) {
      Element task = simulation.children().get(0);
      SimulationElement copy = builder.simulation(task.name());
      simulation.attribute("name").ifPresent(copy::named);
      copyAttributes(task, copy);
      copyChildren(task, copy);
    }
    for (Element part : model.children()) {
      copyOf(part, builder);
    }
    assertThat(elements(document(builder.toString())).toString())
        .isEqualTo(elements(root).toList().toString());
  }

  private static void copyOf(Element element, BuiltElement<?> into) {
    OtherElement copy = into.element(element.name());
    copyAttributes(element, copy);
    copyChildren(element, copy);
  }

  private static void copyAttributes(Element element, BuiltElement<?> copy) {
    element.attributes().forEach(a -> copy.set(a.name(), a.value()));
  }

  private static void copyChildren(Element element, BuiltElement<?> copy) {
    element.children().forEach(child -> copyOf(child, copy));
  }

  /** What is refused at once, and the words of it. */
  record Slip(String message, Consumer<MechanismBuilder> step) {
    @Override
    public String toString() {
      return message;
    }
  }

  static Stream<Slip> slips() {
    return Stream.of(
        new Slip(
            "M-007 body \"bar\": <body> has no attribute \"graphsrc\"; did you mean \"graphSrc\"?",
            model -> model.body("bar").set("graphsrc", "bar.obj")),
        new Slip(
            "M-009 joint \"hinge\": type is \"Q\"; it must be one of R, P, C, U, S, PL, H, F, W",
            model -> model.joint("hinge", "Q")),
        new Slip(
            "M-009 MBSmodel \"Slips\": forceUnits is \"kn\"; it must be one of N, kN, lbf;"
                + " did you mean \"kN\"?",
            model -> model.set("forceUnits", "kn")),
        new Slip(
            "M-023 springDamper \"strut\": \"N/mn\" is not a unit;",
            model -> model.springDamper("strut").set("k", 4, "N/mn")),
        new Slip(
            "M-023 body \"bar\": mass: \"kgg\" is not a unit;",
            model -> model.body("bar").mass(1, "kgg")),
        new Slip(
            "M-006 <sprngDamper> is not an element of MechML; did you mean <springDamper>?",
            model -> model.element("sprngDamper", "name", "strut")),
        new Slip(
            "M-010 body \"bar\": <gravity> does not belong here; <body> holds",
            model -> model.body("bar").element("gravity")),
        new Slip(
            "M-010 body \"bar\": <mass> is out of order or one too many;",
            model -> model.body("bar").mass(1).mass(2)),
        new Slip(
            "M-010 body \"bar\": <mass> is out of order or one too many;",
            model -> {
              BodyElement bar = model.body("bar");
              bar.sphere(1);
              bar.mass(2);
            }),
        new Slip(
            "M-007 springDamper \"strut\": <springDamper> has no attribute \"at\";",
            model -> model.springDamper("strut").at(0, 0, 0)),
        new Slip(
            "M-021 body \"bar\": point \"tip\": y is NaN; a number must be finite",
            model -> model.body("bar").point("tip", 0, Double.NaN, 0)),
        new Slip(
            "attributes are names and values in turn; that of \"name\" has no value",
            model -> model.element("body", "name")));
  }

  @ParameterizedTest
  @MethodSource("slips")
  void slipIsRefusedAtOnce(Slip slip) {
    MechanismBuilder model = MechanismBuilder.of("Slips");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> slip.step().accept(model))
        .withMessageStartingWith(slip.message());
  }

  @Test
  void whatWasRefusedStaysOut() throws Exception {
    MechanismBuilder model = doublePendulum();
    String before = model.mechml();
    assertThatIllegalArgumentException().isThrownBy(() -> model.joint("hinge", "Q"));
    assertThatIllegalArgumentException().isThrownBy(() -> model.set("massUnits", "pound"));
    assertThatIllegalArgumentException().isThrownBy(() -> model.element("gravity", "x", "1"));
    assertThatIllegalArgumentException().isThrownBy(() -> model.parameter("mass", 1, "kgg"));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> model.parameter("mass", Double.POSITIVE_INFINITY));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> model.start("shoulder").set("posVals", 1, "mn"));
    assertThat(model.mechml()).isEqualTo(before);
  }

  static Stream<Slip> gaps() {
    return Stream.of(
        new Slip(
            "M-014 joint \"elbow2\": body2 names body \"lover\", which does not exist;"
                + " did you mean \"lower\"?",
            model ->
                model
                    .joint("elbow2", "R")
                    .between("upper", "end", "lover", "top")
                    .vectors("y", "y")),
        new Slip(
            "M-014 springDamper \"rope\": body2 names point \"tip\", which body \"lower\" does not"
                + " have; did you mean \"top\"?",
            model -> model.springDamper("rope").set("k", 1).between("ground", "o", "lower", "tip")),
        new Slip("M-015 ", model -> model.body("lower")),
        new Slip(
            "M-008 jointForce \"motor\": attribute \"joint\" is missing",
            model -> model.element("jointForce", "name", "motor", "expression", "1")),
        new Slip(
            "M-010 springDamper \"rope\": <body1> and <body2> are missing",
            model -> model.springDamper("rope").set("k", 1)),
        new Slip(
            "M-024 springDamper \"rope\": the unit \"kg\" measures",
            model ->
                model
                    .springDamper("rope")
                    .set("k", 1, "kg")
                    .between("ground", "o", "lower", "end")),
        new Slip(
            "M-020 jointForce \"motor\": ", model -> model.jointForce("motor", "elbow", "2*(1")),
        new Slip(
            "M-022 jointForce \"motor\": ",
            model -> model.jointForce("motor", "elbow", "stifness")));
  }

  @ParameterizedTest
  @MethodSource("gaps")
  void wholeModelIsCheckedByTheReader(Slip gap) {
    MechanismBuilder model = doublePendulum();
    gap.step().accept(model);
    MechmlException fault = catchThrowableOfType(MechmlException.class, model::model);
    assertThat(fault.diagnostics())
        .anySatisfy(
            one -> {
              assertThat(one.code() + " " + one.message()).startsWith(gap.message());
              assertThat(model.toString().lines().count()).isGreaterThanOrEqualTo(one.line());
              assertThat(one.file()).isEqualTo("DoublePendulum");
            });
  }

  @Test
  void emptyModelSaysWhatIsMissing() {
    MechanismBuilder model = MechanismBuilder.of("Empty");
    MechmlException fault = catchThrowableOfType(MechmlException.class, model::mechml);
    assertThat(fault).hasMessageContaining("<MBSsimulation> is missing");
    assertThat(fault).hasMessageContaining("<Bodies> and <topology> are missing");
  }

  /** A loop of joints in the world with a drive; the four-bar of the examples. */
  @Test
  void fourBarInTheWorldIsThatOfTheFileToTheBit() throws Exception {
    MechanismBuilder bar = MechanismBuilder.of("FourBar");
    bar.dynamic(2, 0.01);
    bar.root("ground");
    bar.body("crank").cylinder(0.01, "0;0;0", "0;0;0.1").set("density", 7850);
    bar.body("coupler").cylinder(0.01, "0;0;0.1", "0.3;0;0.25").set("density", 7850);
    bar.body("rocker").cylinder(0.01, "0.3;0;0.25", "0.25;0;0").set("density", 7850);
    bar.joint("A", "R").between("ground", "crank").at(0, 0, 0).axis(0, 1, 0);
    bar.joint("B", "R").between("crank", "coupler").at(0, 0, 0.1).axis(0, 1, 0);
    bar.joint("C", "R").between("coupler", "rocker").at(0.3, 0, 0.25).axis(0, 1, 0);
    bar.joint("D", "R").between("ground", "rocker").at(0.25, 0, 0).axis(0, 1, 0);
    bar.jointForce("motor", "A", "0.5*(10 - A.v)");
    bar.gravity(0, 0, -9.81);
    MechModel read = MechModel.read(Path.of("../examples/four-bar/four-bar.xml"));
    assertThat(rows(bar.model(), "built.csv")).hasSameBinaryContentAs(rows(read, "read.csv"));
  }

  @Test
  void mapInCodeIsThatOfAFile() throws Exception {
    MechanismBuilder model = doublePendulum();
    model
        .map(
            "brake",
            new double[] {0, 2},
            new double[] {0, 1, 3},
            new double[][] {{1, 2, 3}, {4, 5, 6}})
        .set("extrapolation", "hold");
    assertThat(model.mechml())
        .contains(
            "<map name=\"brake\" x=\"0;2\" y=\"0;1;3\" z=\"1;2;3;4;5;6\" extrapolation=\"hold\"/>");
  }

  @Test
  void startAndDriveOfAJointAreOne() throws Exception {
    MechanismBuilder model = doublePendulum();
    model.drive("shoulder", "0.3 + 0.1*t");
    assertThat(model.toString())
        .contains(
            "<jointVal name=\"shoulder\" posVals=\"0.3\" velVals=\"0\" driven=\"0.3 + 0.1*t\"/>");
  }
}
