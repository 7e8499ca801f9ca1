package org.mechservice.mechml.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.Resources;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;

/** Every element knows where its tag begins. */
class ElementPlaceTest {
  private static Element read(String text, Charset charset) throws MechmlException {
    return DocumentReader.read(text.getBytes(charset), new Diagnostics("model.xml")).root();
  }

  /** Asserts that the text at each element's place is its tag. */
  private static void assertPlaces(Element element, String text) {
    String[] lines = text.split("\r\n|\n", -1);
    String rest = lines[element.position().line() - 1].substring(element.position().column() - 1);
    assertThat(rest).startsWith("<" + element.name());
    element.attribute("name").ifPresent(name -> assertThat(rest).contains(name));
    element.children().forEach(child -> assertPlaces(child, text));
  }

  @ParameterizedTest
  @ValueSource(strings = {"sliding-pendulum.xml", "FiveBarPendulum.xml"})
  void placesAreThoseOfTheTags(String file) throws Exception {
    String text = Resources.text(file);
    assertPlaces(read(text, StandardCharsets.UTF_8), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"\r\n", "\n\n\t"})
  void lineEndsOfUnixAndWindowsCount(String lineEnd) throws Exception {
    String text = Resources.text("sliding-pendulum.xml").replace("\n", lineEnd);
    assertPlaces(read(text, StandardCharsets.UTF_8), text);
  }

  @Test
  void commentsAndInstructionsBetweenTagsDoNotDisplace() throws Exception {
    String text =
        Resources.text("sliding-pendulum.xml")
            .replace("<point", "<!-- a\ncomment --> <?note?> <point")
            .replace("<joint ", "<!----><joint ");
    assertPlaces(read(text, StandardCharsets.UTF_8), text);
  }

  @Test
  void longFilesKeepTheirPlaces() throws Exception {
    String text =
        Resources.text("sliding-pendulum.xml")
            .replace("<cog", "\n  <!-- long -->".repeat(20_000) + "<cog");
    assertPlaces(read(text, StandardCharsets.UTF_8), text);
  }

  @Test
  void encodingDoesNotMatter() throws Exception {
    String text =
        Resources.text("sliding-pendulum.xml")
            .replace("<?xml version=\"1.0\"?>", "<?xml version=\"1.0\" encoding=\"UTF-16\"?>")
            .replace("SlidingPendulum", "Pendel auf Schlitten: größer \uD83D\uDE00");
    assertPlaces(read(text, StandardCharsets.UTF_16), text);
  }

  @Test
  void pathsNameTheElementsAround() throws Exception {
    Element document = read(Resources.text("sliding-pendulum.xml"), StandardCharsets.UTF_8);
    Element body2 =
        document
            .requiredChild("MBSmodel")
            .requiredChild("Joints")
            .children("joint")
            .get(1)
            .requiredChild("body2");
    assertThat(body2.position().path())
        .isEqualTo("MechML/MBSmodel[SlidingPendulum]/Joints/joint[hinge]/body2[bar]");
  }
}
