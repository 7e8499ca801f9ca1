package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** The paper's five-bar pendulum, against the same scene as JSON. */
class PendulumFileTest {
  private static final MechmlModel MODEL = model();
  private static final JsonObject SCENE = scene();

  private static MechmlModel model() {
    try {
      return MechmlReader.read("FiveBarPendulum.xml", Resources.bytes("FiveBarPendulum.xml"));
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
  }

  private static JsonObject scene() {
    try {
      return JsonScene.read("pendulum5").object();
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void bodiesAreThoseOfTheScene() {
    List<Body> expected = new ArrayList<>();
    for (JsonElement element : SCENE.getAsJsonArray("bodies")) {
      JsonObject body = element.getAsJsonObject();
      JsonArray i = body.getAsJsonArray("inertia");
      expected.add(
          new Body(
              body.get("name").getAsString(),
              body.get("mass").getAsDouble(),
              vector(body, "cog"),
              new InertiaTensor(at(i, 0), at(i, 1), at(i, 2), at(i, 3), at(i, 4), at(i, 5)),
              Origin.NONE));
    }
    assertThat(MODEL.mechanism().bodies())
        .usingRecursiveFieldByFieldElementComparatorIgnoringFields("origin")
        .isEqualTo(expected);
  }

  @Test
  void jointsAreThoseOfTheScene() {
    Mechanism mechanism = MODEL.mechanism();
    JsonArray joints = SCENE.getAsJsonArray("joints");
    assertThat(mechanism.joints()).hasSize(joints.size());
    for (int j = 0; j < joints.size(); j++) {
      JsonObject expected = joints.get(j).getAsJsonObject();
      Revolute joint = (Revolute) mechanism.joints().get(j);
      assertThat(joint.name()).isEqualTo(expected.get("name").getAsString());
      assertThat(joint.attachment().parent()).isEqualTo(j - 1);
      assertThat(joint.attachment().child()).isEqualTo(j);
      assertThat(joint.attachment().parentPoint()).isEqualTo(vector(expected, "point1"));
      assertThat(joint.attachment().childPoint()).isEqualTo(vector(expected, "point2"));
      assertThat(joint.attachment().zeroRotation()).isEqualTo(Rotation.IDENTITY);
      assertThat(joint.axis()).isEqualTo(vector(expected, "axis"));
      assertThat(joint.initialPosition()).isZero();
      assertThat(joint.initialVelocity()).isZero();
    }
  }

  @Test
  void rootStandsInTheWorldsFrame() {
    assertThat(MODEL.mechanism().root())
        .isEqualTo(new Root("Ground", Vector3.ZERO, Rotation.IDENTITY));
  }

  @Test
  void gravityIsThatOfTheScene() {
    assertThat(MODEL.mechanism().gravity()).isEqualTo(vector(SCENE, "gravity"));
  }

  @Test
  void settingsAreThoseOfTheFile() {
    assertThat(MODEL.settings())
        .isEqualTo(new SimulationSettings(new RunSettings(0, 3, 0.01, "DE", 1e-5, 1e-5), "auto"));
  }

  @Test
  void partsKnowTheirLine() {
    assertThat(MODEL.mechanism().bodies().get(0).origin())
        .isEqualTo(new Origin("FiveBarPendulum.xml", 17));
    assertThat(MODEL.mechanism().joints().get(1).origin())
        .isEqualTo(new Origin("FiveBarPendulum.xml", 67));
  }

  @Test
  void nothingIsWorthAWarning() {
    assertThat(MODEL.warnings()).isEmpty();
  }

  private static Vector3 vector(JsonObject object, String name) {
    JsonArray a = object.getAsJsonArray(name);
    return new Vector3(at(a, 0), at(a, 1), at(a, 2));
  }

  private static double at(JsonArray array, int index) {
    return array.get(index).getAsDouble();
  }
}
