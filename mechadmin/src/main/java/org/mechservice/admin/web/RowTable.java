package org.mechservice.admin.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.LinkedHashMap;
import java.util.Map;

/** Rows of JSON by their key, each with the version in which it last changed or went. */
final class RowTable {
  /** Removals older than this are forgotten; a page that was away longer gets a full update. */
  private static final int GONE_KEPT = 10_000;

  private record Row(JsonObject json, long version) {}

  private final Map<String, Row> rows = new LinkedHashMap<>();
  private final Map<String, Long> gone =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Long> eldest) {
          return size() > GONE_KEPT;
        }
      };

  /** Takes over all rows there are now. */
  void replace(Map<String, JsonObject> now, long version) {
    rows.keySet()
        .removeIf(
            key -> {
              boolean went = !now.containsKey(key);
              if (went) {
                gone.put(key, version);
              }
              return went;
            });
    now.forEach(
        (key, json) -> {
          Row known = rows.get(key);
          if (known == null || !known.json().equals(json)) {
            rows.put(key, new Row(json, version));
            gone.remove(key);
          }
        });
  }

  /** Returns the rows changed or removed after a version. */
  JsonObject after(long version) {
    JsonArray changed = new JsonArray();
    rows.values().stream()
        .filter(row -> row.version() > version)
        .forEach(row -> changed.add(row.json()));
    JsonArray went = new JsonArray();
    gone.forEach(
        (key, when) -> {
          if (when > version) {
            went.add(key);
          }
        });
    JsonObject update = new JsonObject();
    update.add("changed", changed);
    update.add("gone", went);
    return update;
  }
}
