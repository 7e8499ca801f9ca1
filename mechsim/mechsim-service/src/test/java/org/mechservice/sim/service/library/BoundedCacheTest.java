package org.mechservice.sim.service.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Words, at most three of them and ten letters together. */
class BoundedCacheTest {
  private final BoundedCache<String, String> latest = new BoundedCache<>(3, 10, String::length);
  private final List<String> made = new ArrayList<>();

  private String get(String word) {
    return latest.get(
        word,
        Runnable::run,
        () -> {
          made.add(word);
          return word;
        });
  }

  private void assertKept(String... words) {
    assertThat(List.of("a", "b", "c", "d", "sevenof", "larger than all"))
        .filteredOn(word -> latest.known(word).isPresent())
        .containsExactlyInAnyOrder(words);
  }

  @Test
  void aValueThatIsThereIsNotMadeAgain() {
    assertThat(get("a")).isEqualTo("a");
    assertThat(get("a")).isEqualTo("a");
    assertThat(made).containsExactly("a");
  }

  @Test
  void theOneUsedLongestAgoGoesWhereThereAreTooMany() {
    List.of("a", "b", "c", "a", "d").forEach(this::get);
    assertKept("a", "c", "d");
  }

  @Test
  void thoseUsedLongestAgoGoWhereAllAreTooLarge() {
    List.of("a", "b", "sevenof").forEach(this::get);
    assertKept("a", "b", "sevenof");
    get("c");
    assertKept("b", "c", "sevenof");
  }

  @Test
  void oneThatIsTooLargeByItselfStaysUntilTheNext() {
    List.of("a", "larger than all").forEach(this::get);
    assertKept("larger than all");
    get("b");
    assertKept("b");
  }

  @Test
  void whatIsForgottenIsMadeAgain() {
    get("a");
    latest.forget("a");
    assertKept();
    get("a");
    assertThat(made).containsExactly("a", "a");
  }

  @Test
  void whatFailedIsThrownAndTriedAgain() {
    assertThatThrownBy(
            () ->
                latest.get(
                    "a",
                    Runnable::run,
                    () -> {
                      throw new IllegalArgumentException("no");
                    }))
        .isInstanceOf(IllegalArgumentException.class);
    assertThat(get("a")).isEqualTo("a");
  }
}
