package org.mechservice.admin.watch;

import org.jline.keymap.KeyMap;
import org.jline.terminal.Terminal;
import org.jline.utils.InfoCmp.Capability;

/** The keys of the full screen. */
enum WatchKey {
  UP,
  DOWN,
  PAGE_UP,
  PAGE_DOWN,
  FIRST,
  LAST,
  SORT,
  REVERSE,
  FILTER,
  INSPECT,
  CANCEL,
  YES,
  BACK,
  QUIT,
  OTHER;

  /** A lone escape differs from the beginning of an arrow key: no character follows it. */
  private static final long ESCAPE_MILLIS = 100;

  static KeyMap<WatchKey> of(Terminal terminal) {
    KeyMap<WatchKey> keys = new KeyMap<>();
    keys.bind(UP, "k", KeyMap.key(terminal, Capability.key_up), "\u001b[A");
    keys.bind(DOWN, "j", KeyMap.key(terminal, Capability.key_down), "\u001b[B");
    keys.bind(PAGE_UP, KeyMap.key(terminal, Capability.key_ppage), "\u001b[5~");
    keys.bind(PAGE_DOWN, " ", KeyMap.key(terminal, Capability.key_npage), "\u001b[6~");
    keys.bind(FIRST, "g", KeyMap.key(terminal, Capability.key_home), "\u001b[H");
    keys.bind(LAST, "G", KeyMap.key(terminal, Capability.key_end), "\u001b[F");
    keys.bind(SORT, "s");
    keys.bind(REVERSE, "r");
    keys.bind(FILTER, "f");
    keys.bind(INSPECT, "i", "\r", "\n");
    keys.bind(CANCEL, "c");
    keys.bind(YES, "y");
    keys.bind(BACK, "\u001b", "\u007f", "n");
    keys.bind(QUIT, "q", "\u0003");
    keys.setUnicode(OTHER);
    keys.setNomatch(OTHER);
    keys.setAmbiguousTimeout(ESCAPE_MILLIS);
    return keys;
  }
}
