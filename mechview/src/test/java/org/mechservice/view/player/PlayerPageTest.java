package org.mechservice.view.player;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.mechservice.view.scene.SceneDescription;

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

    assertThat(page).doesNotContain("http:", "https:", "import ", "innerHTML", "eval(", " style=");
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
  void geometryThatIsMissingIsNamedAndReplacedByAShape() {
    Stage stage = new Stage(Pendulums.scene("bar", "bar.wrl"), new MeshFolder(Path.of(".")));

    assertThat(stage.warnings())
        .singleElement()
        .asString()
        .startsWith("body bar is drawn as a simple shape: graphSrc \"bar.wrl\"");
    assertThat(stage.parts()).anyMatch(part -> part.body() == 0 && part.role() == Part.Role.BODY);
  }
}
