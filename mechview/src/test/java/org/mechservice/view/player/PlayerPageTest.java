package org.mechservice.view.player;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;

/** The player's page holds a run as data, and nothing that can be fetched or run besides. */
class PlayerPageTest {
  private static final String HOSTILE = "</script><img src=x onerror=alert(1)>{{script}}";

  private static String page(String bodyName) {
    SceneDescription scene = Pendulums.scene(bodyName, "");
    Stage stage = new Stage(scene, new MeshFolder(Path.of(".")));
    return new String(
        PlayerPage.write(
            scene,
            stage,
            Pendulums.recording(bodyName, 5, 0.1),
            Map.of("where " + bodyName, bodyName),
            List.of(new PlayerPage.Event(0.2, bodyName))),
        StandardCharsets.UTF_8);
  }

  private static String find(String page, String pattern) {
    Matcher matcher = Pattern.compile(pattern, Pattern.DOTALL).matcher(page);
    assertThat(matcher.find()).as(pattern).isTrue();
    return matcher.group(1);
  }

  private static JsonObject data(String page) {
    String text = find(page, "<script type=\"application/json\" id=\"data\">(.*?)</script>");
    return JsonParser.parseString(text).getAsJsonObject();
  }

  @Test
  void namesAreDataWhateverTheyAre() {
    String page = page(HOSTILE);

    assertThat(page).doesNotContain("<img");
    assertThat(
            data(page).getAsJsonArray("bodies").get(0).getAsJsonObject().get("name").getAsString())
        .isEqualTo(HOSTILE);
    assertThat(page.split("</script>", -1)).hasSize(3);
  }

  @Test
  void policyNamesTheOneScriptAndTheOneStyleByTheirHashes() throws Exception {
    String page = page("bar");
    String policy = find(page, "Content-Security-Policy\" content=\"(.*?)\"");

    assertThat(policy).startsWith("default-src 'none';").doesNotContain("unsafe");
    for (String text :
        List.of(
            find(page, "<script type=\"module\">(.*?)</script>"),
            find(page, "<style>(.*?)</style>"))) {
      byte[] hash =
          MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
      assertThat(policy).contains("'sha256-" + Base64.getEncoder().encodeToString(hash) + "'");
    }
  }

  @Test
  void nothingIsFetchedAndNoTextBecomesMarkup() {
    String page = page("bar");

    // three.js names a paper by its address, and namespaces are addresses
    int three = page.indexOf("const THREE_CORE");
    int after = page.indexOf("// Vectors, and unit quaternions");
    String own =
        (page.substring(0, three) + page.substring(after))
            .replace("http://www.w3.org/2000/svg", "");

    assertThat(page.length() - own.length()).isGreaterThan(700_000);
    assertThat(own).doesNotContain("http:", "https:", "import ", "innerHTML", "eval(", " style=");
  }

  @Test
  void numbersAreFloatsColumnAfterColumn() {
    JsonObject data = data(page("bar"));
    ByteBuffer values =
        ByteBuffer.wrap(Base64.getDecoder().decode(data.get("values").getAsString()))
            .order(ByteOrder.LITTLE_ENDIAN);

    assertThat(data.get("frames").getAsInt()).isEqualTo(5);
    assertThat(values.capacity()).isEqualTo(4 * 5 * 8);
    assertThat(values.getFloat(4 * 1)).isEqualTo(0.1f);
    assertThat(values.getFloat(4 * (4 * 5 + 2))).isEqualTo((float) Math.cos(Math.PI / 10));
  }

  @Test
  void normalOfAContactIsInAxesOfTheBodyOfItsSurface() {
    SceneDescription still = Pendulums.scene("bar", "");
    double half = Math.sqrt(0.5);
    SceneBody turned =
        new SceneBody(
            "bar",
            new BodyPose(Point3.ZERO, half, 0, half, 0),
            1,
            Point3.ZERO,
            List.of(0.0, 0.1, 0.1, 0.0, 0.0, 0.0),
            "");
    SceneForce contact =
        new SceneForce(
            "touch",
            SceneForce.Kind.CONTACT,
            List.of(new Anchor(Anchor.ROOT, Point3.ZERO), new Anchor(0, Point3.ZERO)),
            new Point3(1, 0, 0),
            false,
            0.1,
            "");
    SceneDescription scene =
        new SceneDescription(
            still.name(),
            still.rootName(),
            BodyPose.WORLD,
            "",
            List.of(),
            still.gravity(),
            List.of(turned),
            still.joints(),
            List.of(),
            List.of(contact),
            still.verdict());
    String page =
        new String(
            PlayerPage.write(
                scene,
                new Stage(scene, new MeshFolder(Path.of("."))),
                Pendulums.recording("bar", 5, 0.1),
                Map.of(),
                List.of()),
            StandardCharsets.UTF_8);

    JsonArray direction =
        data(page).getAsJsonArray("forces").get(0).getAsJsonObject().getAsJsonArray("direction");
    assertThat(direction.get(0).getAsDouble()).isCloseTo(0, within(1e-12));
    assertThat(direction.get(2).getAsDouble()).isCloseTo(1, within(1e-12));
  }

  @Test
  void geometryThatIsMissingIsNamedAndReplacedByAShape() {
    Stage stage = new Stage(Pendulums.scene("bar", "bar.wrl"), new MeshFolder(Path.of(".")));

    assertThat(stage.warnings())
        .singleElement()
        .asString()
        .startsWith("body bar is drawn as a simple shape: graphSrc \"bar.wrl\"");
    assertThat(stage.parts(new Recording()))
        .anyMatch(part -> part.body() == 0 && part.role() == Part.Role.BODY);
  }
}
