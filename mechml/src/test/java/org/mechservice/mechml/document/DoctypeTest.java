package org.mechservice.mechml.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.Resources;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;

/** Whatever the DOCTYPE says, the bundled grammar rules. */
class DoctypeTest {
  private static final String DOCTYPE = "<!DOCTYPE MechML SYSTEM \"MechML.dtd\">";

  private static String withDoctype(String doctype) throws Exception {
    return Resources.text("sliding-pendulum.xml").replace(DOCTYPE, doctype);
  }

  private static Element read(String text) throws MechmlException {
    return DocumentReader.read(text.getBytes(StandardCharsets.UTF_8), new Diagnostics("model.xml"))
        .root();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "<!DOCTYPE MechML>",
        "<!DOCTYPE MechML SYSTEM \"mechml.dtd\">",
        "<!DOCTYPE MechML SYSTEM \"MECHML.DTD\">",
        "<!DOCTYPE MechML SYSTEM \"../grammar/MechML.dtd\">",
        "<!DOCTYPE MechML SYSTEM \"file:///no/such/place/MechML.dtd\">",
        "<!DOCTYPE MechML SYSTEM \"http://127.0.0.1:1/MechML.dtd\">",
        "<!DOCTYPE MechML PUBLIC \"-//MechML\" \"MechML.dtd\">",
        "<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [<!ENTITY half \"0.5\">]>"
      })
  void bundledGrammarChecksTheFile(String doctype) throws Exception {
    String text = withDoctype(doctype);
    assertThat(read(text).name()).isEqualTo("MechML");
    assertThatThrownBy(() -> read(text.replace("<mass value", "<mass weight")))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("<mass> has no attribute \"weight\"");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<!DOCTYPE MechML SYSTEM \"other.dtd\">",
        "<!DOCTYPE MechML SYSTEM \"MechML.dtd.txt\">",
        "<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [<!ENTITY x SYSTEM \"MechML.dtd\">]>",
        "<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [<!ENTITY % x SYSTEM \"MechML.dtd\"> %x;]>",
        "<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [<!ENTITY % x SYSTEM \"file:///etc/hostname\">"
            + " %x;]>",
        "<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [<!ENTITY x PUBLIC \"x\" \"http://127.0.0.1:1/\">]>"
      })
  void everythingElseOutsideIsRefused(String doctype) throws Exception {
    String text = withDoctype(doctype);
    assertThatThrownBy(() -> read(text))
        .isInstanceOfSatisfying(
            MechmlException.class,
            e ->
                assertThat(e.diagnostics())
                    .singleElement()
                    .returns(MessageCode.REFERS_TO_OTHER_FILE, d -> d.code()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<!ELEMENT body ANY>",
        "<!ATTLIST mass value CDATA \"5\">",
        "<!ENTITY % x \"<!ELEMENT body ANY>\"> %x;"
      })
  void filesDeclareNoGrammarOfTheirOwn(String declaration) throws Exception {
    String text = withDoctype("<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [" + declaration + "]>");
    assertThatThrownBy(() -> read(text))
        .isInstanceOfSatisfying(
            MechmlException.class,
            e ->
                assertThat(e.diagnostics())
                    .singleElement()
                    .returns(MessageCode.DOCTYPE_DECLARES, d -> d.code()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"&half;", "&#48;.5"})
  void shortEntitiesAreReplaced(String value) throws Exception {
    String text =
        withDoctype("<!DOCTYPE MechML SYSTEM \"MechML.dtd\" [<!ENTITY half \"0.5\">]>")
            .replace("<cog x=\"0.5\"", "<cog x=\"" + value + "\"");
    Element bar =
        read(text).requiredChild("MBSmodel").requiredChild("Bodies").children("body").get(2);
    assertThat(bar.requiredChild("cog").required("x")).isEqualTo("0.5");
  }
}
