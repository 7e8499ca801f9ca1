package org.mechservice.sim.fmu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class FmuArchiveTest {
  @ParameterizedTest
  @EnumSource
  void sameModelGivesSameBytes(FmiVersion version) throws IOException {
    byte[] once = FmuArchive.build(CModels.ball(), version, Set.of()).bytes();
    assertThat(FmuArchive.build(CModels.ball(), version, Set.of()).bytes()).isEqualTo(once);
  }

  @Test
  void anotherModelHasAnotherToken() throws IOException {
    FmuModel ball = CModels.ball();
    SortedMap<String, String> sources = new TreeMap<>(ball.sources());
    sources.merge("ball.c", "/* changed */\n", String::concat);
    FmuModel changed =
        new FmuModel(
            ball.name(),
            ball.identifier(),
            ball.states(),
            ball.parameters(),
            ball.inputs(),
            ball.outputs(),
            ball.events(),
            ball.experiment(),
            sources);
    assertThat(description(ball, FmiVersion.FMI_2)).contains("guid=\"{");
    assertThat(guid(changed)).isNotEqualTo(guid(ball));
  }

  private static String guid(FmuModel model) throws IOException {
    return description(model, FmiVersion.FMI_2).replaceAll("(?s).*guid=\"([^\"]*)\".*", "$1");
  }

  @Test
  void unitOfSourcesHasNoBinaryAndSaysSo() throws IOException {
    FmuArchive archive = FmuArchive.build(CModels.ball(), FmiVersion.FMI_3, Set.of());
    assertThat(archive.contents()).contains("sources only");
    assertThat(entries(archive).keySet())
        .contains("modelDescription.xml", "sources/buildDescription.xml", "sources/mech_fmi3.c")
        .noneMatch(name -> name.startsWith("binaries/"));
  }

  @Test
  void stateAmongTheOutputsIsOneVariable() throws IOException {
    String text = description(CModels.ball(), FmiVersion.FMI_2);
    assertThat(text.split("name=\"z.x\"", -1)).hasSize(2);
    assertThat(text).contains("name=\"z.x\" valueReference=\"1\"").contains("causality=\"output\"");
  }

  @Test
  void textOfTheModelStaysText() throws IOException {
    assertThat(description(CModels.ball(), FmiVersion.FMI_3))
        .contains("Restitution &amp; &quot;bounce&quot; &lt; 1");
  }

  private static String description(FmuModel model, FmiVersion version) throws IOException {
    return entries(FmuArchive.build(model, version, Set.of()))
        .getOrDefault("modelDescription.xml", "");
  }

  private static SortedMap<String, String> entries(FmuArchive archive) throws IOException {
    SortedMap<String, String> entries = new TreeMap<>();
    try (ZipInputStream in = new ZipInputStream(new ByteArrayInputStream(archive.bytes()))) {
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        entries.put(entry.getName(), new String(in.readAllBytes(), StandardCharsets.UTF_8));
      }
    }
    return entries;
  }

  @ParameterizedTest
  @ValueSource(strings = {"4", "", "1", "2.1"})
  void unknownVersionIsRefusedByName(String number) {
    assertThatThrownBy(() -> FmiVersion.of(number))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("FMI " + number)
        .hasMessageContaining("write 2 or 3");
  }

  @ParameterizedTest
  @ValueSource(strings = {"amiga", "", "linux64,", "source,linux64", "LINUX64"})
  void unknownPlatformIsRefusedByName(String list) {
    assertThatThrownBy(() -> FmuPlatform.parse(list))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("linux64, win64, darwin-aarch64, linux-aarch64");
  }

  @Test
  void platformsAreAList() {
    assertThat(FmuPlatform.parse("win64, linux64"))
        .containsExactly(FmuPlatform.LINUX64, FmuPlatform.WIN64);
    assertThat(FmuPlatform.parse("source")).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({
    "m/s^2, 0 1 -2 0 0 0 0 0",
    "N*m, 1 2 -2 0 0 0 0 0",
    "N*m*s/rad, 1 2 -1 0 0 0 0 -1",
    "N/(m/s), 1 0 -1 0 0 0 0 0",
    "rad/s/s, 0 0 -2 0 0 0 0 1",
    "J/(kg*m), 0 1 -2 0 0 0 0 0",
    "1, 0 0 0 0 0 0 0 0"
  })
  void unitsAreProductsOfBaseUnits(String unit, String powers) {
    List<Integer> expected = List.of(powers.split(" ", -1)).stream().map(Integer::valueOf).toList();
    assertThat(BaseUnits.of(unit)).isEqualTo(Optional.of(new BaseUnits(expected)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"furlong", "m^", "m//s", "m s", "(m", "deg"})
  void whatIsNoProductHasNoBaseUnits(String unit) {
    assertThat(BaseUnits.of(unit)).isEmpty();
  }
}
