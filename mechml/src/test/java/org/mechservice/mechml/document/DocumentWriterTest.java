package org.mechservice.mechml.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.mechml.Resources;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;

/** What is written is what was read. */
class DocumentWriterTest {
  static Stream<Path> examples() throws IOException {
    try (Stream<Path> files = Files.walk(Path.of("..", "examples"))) {
      return files
          .filter(f -> f.toString().endsWith(".xml") && !f.endsWith("pom.xml"))
          .filter(f -> !f.toString().contains("target"))
          .filter(f -> !f.toString().contains("study"))
          // Its point is its few lines.
          .filter(f -> !f.endsWith("four-bar.xml"))
          .toList()
          .stream();
    }
  }

  private static String rewritten(String text) throws MechmlException {
    byte[] content = text.getBytes(StandardCharsets.UTF_8);
    return DocumentWriter.write(MechmlReader.document("model.xml", content));
  }

  @ParameterizedTest
  @MethodSource("examples")
  void examplesAreWrittenAsTheyWereRead(Path file) throws Exception {
    String text = Files.readString(file);
    assertThat(rewritten(text)).isEqualTo(text);
  }

  @Test
  void filesThatAreNotCanonicalKeepWhatTheySay() throws Exception {
    String text =
        Resources.text("sliding-pendulum.xml")
            .replace("    ", "\t")
            .replace("\"PI/6\"", "' PI\n/6 '")
            .replace("<Bodies>", "<Bodies><!-- of steel; <b> & \"c\" -->")
            .replace("</MechML>", "</MechML><!-- the end -->");
    String canonical = rewritten(text);
    assertThat(canonical)
        .contains("posVals=\" PI /6 \"", "<!-- of steel; <b> & \"c\" -->")
        .endsWith("</MechML>\n<!-- the end -->\n");
    assertThat(rewritten(canonical)).isEqualTo(canonical);
  }

  @Test
  void charactersThatMeanSomethingInXmlSurvive() throws Exception {
    String name = "a&amp;b&lt;c&quot;d&#10;e'f>g";
    String text = Resources.text("sliding-pendulum.xml").replace("SlidingPendulum", name);
    assertThat(rewritten(text)).contains("name=\"" + name + "\"");
  }

  @Test
  void entitiesBecomeTheirText() throws Exception {
    String text =
        Resources.text("sliding-pendulum.xml")
            .replace("\"MechML.dtd\"", "\"MechML.dtd\" [<!ENTITY half '0.5'>]")
            .replace("x=\"0.5\"", "x=\"&half;\"");
    assertThat(rewritten(text)).isEqualTo(rewritten(Resources.text("sliding-pendulum.xml")));
  }

  @Test
  void aDoctypeIsKeptAndNoneIsAdded() throws Exception {
    String text = Resources.text("sliding-pendulum.xml");
    String doctype = "<!DOCTYPE MechML SYSTEM \"MechML.dtd\">\n";
    assertThat(rewritten(text)).contains(doctype);
    assertThat(rewritten(text.replace(doctype, ""))).doesNotContain("DOCTYPE");
  }

  @Test
  void aDocumentMadeOfElementsCanBeRead() throws Exception {
    Document read = MechmlReader.document("model.xml", Resources.bytes("sliding-pendulum.xml"));
    String text = DocumentWriter.write(Document.of(read.root()));
    assertThat(text).contains("SYSTEM \"mechml.dtd\"");
    assertThat(MechmlReader.read("model.xml", text.getBytes(StandardCharsets.UTF_8)).warnings())
        .isEqualTo(List.of());
  }
}
