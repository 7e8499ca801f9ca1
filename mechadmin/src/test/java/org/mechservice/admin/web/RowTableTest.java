package org.mechservice.admin.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RowTableTest {
  private final RowTable table = new RowTable();

  private static JsonObject row(String text) {
    JsonObject row = new JsonObject();
    row.addProperty("text", text);
    return row;
  }

  @Test
  void onlyWhatChangedOrWentIsTold() {
    table.replace(Map.of("a", row("1"), "b", row("1")), 1);
    table.replace(Map.of("a", row("1"), "b", row("2")), 2);
    assertThat(table.after(0).getAsJsonArray("changed")).hasSize(2);
    assertThat(table.after(1)).hasToString("{\"changed\":[{\"text\":\"2\"}],\"gone\":[]}");
    table.replace(Map.of("b", row("2")), 3);
    assertThat(table.after(2)).hasToString("{\"changed\":[],\"gone\":[\"a\"]}");
    table.replace(Map.of("a", row("1"), "b", row("2")), 4);
    assertThat(table.after(2)).hasToString("{\"changed\":[{\"text\":\"1\"}],\"gone\":[]}");
    assertThat(table.after(4)).hasToString("{\"changed\":[],\"gone\":[]}");
  }
}
