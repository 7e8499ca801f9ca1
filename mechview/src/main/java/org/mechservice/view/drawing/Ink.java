package org.mechservice.view.drawing;

/**
 * The purposes of colours, each with its value on light and on dark pages. The eight curve colours
 * differ in hue and have a contrast of at least 4.5 to 1 to the page (WCAG 2.2, 1.4.3), so that
 * text in them is legible too.
 */
public enum Ink {
  PAGE("#ffffff", "#14171c"),
  TEXT("#1c2128", "#e6e9ee"),
  MUTED("#59636f", "#a3adb9"),
  GRID("#e3e7ec", "#2b313a"),
  AXIS("#8a94a0", "#6d7783"),
  BODY("#dfe6ee", "#2f3a47"),
  CURVE_0("#1f6fb4", "#6cb2f2"),
  CURVE_1("#b4520a", "#f0a054"),
  CURVE_2("#23803a", "#6fcf84"),
  CURVE_3("#7b4ab5", "#bb98ee"),
  CURVE_4("#c22f3b", "#f27d84"),
  CURVE_5("#0f7b82", "#52c9d0"),
  CURVE_6("#85561f", "#d0a172"),
  CURVE_7("#ab3179", "#ee86c2");

  private static final Ink[] CURVES = {
    CURVE_0, CURVE_1, CURVE_2, CURVE_3, CURVE_4, CURVE_5, CURVE_6, CURVE_7
  };

  /** Number of colours that tell curves apart. */
  public static final int CURVE_COUNT = CURVES.length;

  private final String light;
  private final String dark;

  Ink(String light, String dark) {
    this.light = light;
    this.dark = dark;
  }

  /** Returns the colour of a curve; they repeat after {@link #CURVE_COUNT}. */
  public static Ink curve(int index) {
    return CURVES[Math.floorMod(index, CURVES.length)];
  }

  /** Returns the colour as {@code #rrggbb}; that of light pages for {@link Theme#AUTOMATIC}. */
  public String hex(Theme theme) {
    return theme == Theme.DARK ? dark : light;
  }
}
