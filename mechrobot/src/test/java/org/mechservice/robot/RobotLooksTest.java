package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;

/** Bodies of imported robots look as their files say: every visual with place, size and colour. */
class RobotLooksTest {
  private static final String STL =
      """
      solid t
      facet normal 0 0 1
      outer loop
      vertex 0 0 0
      vertex 1 0 0
      vertex 0 2 0
      endloop
      endfacet
      endsolid t
      """;

  @TempDir private Path folder = Path.of("");

  private RobotImport imported(String name, String text) throws IOException, MechmlException {
    Path file = Files.writeString(folder.resolve(name), text);
    return RobotImport.read(
        file,
        new ImportOptions(
            Optional.empty(), Optional.empty(), false, List.of(), Optional.of("m-looks")));
  }

  /** Returns the JSON of a binary glTF, whose lengths fit. */
  private static String json(RobotImport robot, String link) {
    byte[] file = robot.looks().getOrDefault("m-looks/" + link + ".glb", new byte[20]);
    ByteBuffer bytes = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    assertThat(bytes.getInt(8)).isEqualTo(file.length);
    return new String(file, 20, bytes.getInt(12), StandardCharsets.UTF_8);
  }

  @Test
  void visualsOfUrdfAreInOneFileWithPlaceScaleAndColour() throws IOException, MechmlException {
    Files.writeString(folder.resolve("t.stl"), STL);
    RobotImport robot =
        imported(
            "r.urdf",
            "<robot name='r'><material name='red'><color rgba='1 0 0 0.5'/></material><link name='a b'>"
                + "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/>"
                + "</inertial><visual><origin xyz='1 2 3'/><geometry><box size='0.2 0.4 0.6'/></geometry>"
                + "<material name='red'/></visual><visual><origin rpy='0 0 "
                + Math.PI / 2
                + "'/><geometry><mesh filename='t.stl' scale='2 2 2'/></geometry></visual>"
                + "<visual><geometry><mesh filename='none.stl'/></geometry></visual></link></robot>");
    assertThat(DocumentWriter.write(robot.document())).contains("graphSrc=\"m-looks/a_b.glb\"");
    String json = json(robot, "a_b");
    // The box about its place; the triangle twice as large and turned from x to y.
    assertThat(json)
        .contains("\"min\":[0.8999999761581421,1.7999999523162842,2.700000047683716]")
        .contains("\"min\":[-4.0,")
        .contains("[1.0,0.0,0.0,0.5]", "\"alphaMode\":\"BLEND\"");
    // What is not found is said, and is no more than a picture.
    assertThat(robot.losses())
        .anyMatch(
            loss -> loss.code() == LossGrade.PICTURE.code() && loss.message().contains("none.stl"));
  }

  @Test
  void visualsOfSdfAndMjcfHaveTheirColours() throws IOException, MechmlException {
    RobotImport sdf =
        imported(
            "r.sdf",
            "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><pose>0 0 1 0 0 0</pose>"
                + "<transparency>0.5</transparency><geometry><sphere><radius>0.5</radius></sphere>"
                + "</geometry><material><diffuse>0 1 0 1</diffuse></material></visual></link></model></sdf>");
    assertThat(json(sdf, "l")).contains("[0.0,1.0,0.0,0.5]", "0.5]", ",1.5]");
    RobotImport mjcf =
        imported(
            "r.xml",
            "<mujoco><asset><material name='blue' rgba='0 0 1 1'/></asset><worldbody><body name='b'>"
                + "<joint/><geom type='box' size='1 2 3' material='blue'/><geom group='3' size='9'/>"
                + "<geom type='capsule' fromto='0 0 5 0 0 7' size='0.5' rgba='1 1 1 1'/></body>"
                + "</worldbody></mujoco>");
    // The hidden group is not shown.
    assertThat(json(mjcf, "b"))
        .contains("[0.0,0.0,1.0,1.0]", "\"max\":[1.0,2.0,3.0]", ",7.5]")
        .doesNotContain("9.0");
  }

  /** A file in centimetres with a node that is moved, and a quadrangle. */
  @Test
  void colladaIsReadInMetresWithItsColours() throws IOException, MechmlException {
    Files.writeString(
        folder.resolve("q.dae"),
        "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset><unit"
            + " meter='0.01'/><up_axis>Z_UP</up_axis></asset><library_effects><effect id='e'>"
            + "<profile_COMMON><technique sid='c'><lambert><diffuse><color>0 1 0 1</color></diffuse>"
            + "</lambert></technique></profile_COMMON></effect></library_effects><library_materials>"
            + "<material id='m'><instance_effect url='#e'/></material></library_materials>"
            + "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='f' count='12'>"
            + "0 0 0 100 0 0 100 100 0 0 100 0</float_array></source><vertices id='v'><input"
            + " semantic='POSITION' source='#p'/></vertices><polylist material='s' count='1'><input"
            + " semantic='VERTEX' source='#v' offset='0'/><input semantic='NORMAL' source='#n' offset='1'/>"
            + "<vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist></mesh></geometry></library_geometries>"
            + "<library_visual_scenes><visual_scene id='w'><node><translate>0 0 200</translate>"
            + "<instance_geometry url='#g'><bind_material><technique_common><instance_material"
            + " symbol='s' target='#m'/></technique_common></bind_material></instance_geometry></node>"
            + "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#w'/></scene>"
            + "</COLLADA>");
    RobotImport robot =
        imported(
            "r.urdf",
            "<robot name='r'><link name='l'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1'"
                + " ixy='0' ixz='0' iyz='0'/></inertial><visual><geometry><mesh filename='q.dae'/>"
                + "</geometry></visual></link></robot>");
    assertThat(json(robot, "l"))
        .contains(
            "\"min\":[0.0,0.0,2.0],\"max\":[1.0,1.0,2.0]", "\"count\":6", "[0.0,1.0,0.0,1.0]");
  }

  /** Without a folder for such files a plain mesh keeps its name. */
  @Test
  void meshKeepsItsNameWhereNoFilesAreWritten() throws MechmlException {
    RobotImport robot =
        RobotImport.of(
            "r",
            "<robot name='r'><link name='l'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial><visual><geometry><mesh filename='l.stl'/></geometry></visual></link></robot>"
                .getBytes(StandardCharsets.UTF_8));
    assertThat(robot.looks()).isEmpty();
    assertThat(robot.losses()).isEmpty();
    assertThat(DocumentWriter.write(robot.document())).contains("graphSrc=\"l.stl\"");
  }
}
