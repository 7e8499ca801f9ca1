package org.mechservice.sim.service.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Long texts in parts: nothing is lost or split, and a text is kept for all of its parts. */
class LongTextsTest {
  private static String longText() {
    return "a".repeat(LongTexts.PART - 1) + "\uD83D\uDE00" + "b".repeat(LongTexts.PART);
  }

  @Test
  void partsTogetherAreTheTextAndNoCharacterIsSplit() {
    String text = longText();
    StringBuilder all = new StringBuilder();
    int parts = 0;
    for (String part = LongTexts.part(text, 0); !part.isEmpty(); parts++) {
      assertThat(part.length()).isLessThanOrEqualTo(LongTexts.PART + 1);
      assertThat(Character.isHighSurrogate(part.charAt(part.length() - 1))).isFalse();
      all.append(part);
      part = LongTexts.part(text, parts + 1);
    }
    assertThat(parts).isEqualTo(3);
    assertThat(all.toString().equals(text)).isTrue();
    assertThat(LongTexts.part("short", 0)).isEqualTo("short");
    assertThat(LongTexts.part("short", 1)).isEmpty();
  }

  @Test
  void longTextIsKeptForItsPartsAndNotForAnotherModel() {
    LongTexts texts = new LongTexts();
    String first = texts.keep(List.of("model", true), longText());
    assertThat(texts.of(List.of("model", true))).containsSame(first);
    assertThat(texts.of(List.of("model", false))).isEmpty();
    texts.keep(List.of("model", false), "short");
    assertThat(texts.of(List.of("model", true))).containsSame(first);
    assertThat(texts.of(List.of("model", false))).isEmpty();
  }
}
