package org.mechservice.mechml.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NearestTest {
  @ParameterizedTest
  @CsvSource({
    "bra, bar", // two neighbours swapped
    "ba, bar", // one letter left out
    "barr, bar", // one too many
    "BAR, bar", // case
    "bat, bar", // one changed
    "Grund, Ground"
  })
  void slipsOfTheKeyboardAreRecognised(String word, String meant) {
    assertThat(NearestName.of(word, List.of("Ground", "wheel", "bar"))).contains(meant);
  }

  @ParameterizedTest
  @CsvSource({"chassis", "be", "w"})
  void wordsThatAreFarFromAllSuggestNothing(String word) {
    assertThat(NearestName.of(word, List.of("Ground", "wheel", "bar"))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"bar9, bar1"})
  void theFirstOfEquallyNearOnesIsSuggested(String word, String meant) {
    assertThat(NearestName.of(word, List.of("bar1", "bar2", "bar3"))).contains(meant);
  }

  @Test
  void anotherLetterIsNotMeant() {
    assertThat(NearestName.of("q", List.of("L", "k"))).isEmpty();
    assertThat(NearestName.of("K", List.of("L", "k"))).contains("k");
  }
}
