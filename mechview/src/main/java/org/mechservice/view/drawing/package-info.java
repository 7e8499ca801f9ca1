/**
 * Pictures made of lines, areas and texts, written as SVG or PNG.
 *
 * <p>{@link org.mechservice.view.drawing.Canvas} collects what a picture consists of, in pixels
 * from the upper left corner. Shapes are those of {@code java.awt.geom}; colours are roles ({@link
 * org.mechservice.view.drawing.Ink}), so that one picture serves light and dark pages. {@link
 * org.mechservice.view.drawing.Svg} and {@link org.mechservice.view.drawing.Png} write it: an SVG
 * file follows the colour scheme of its reader unless a {@link org.mechservice.view.drawing.Theme}
 * is demanded, and carries a title and a description for screen readers.
 *
 * <p>Texts are measured by {@link org.mechservice.view.drawing.Label#box} with widths that no usual
 * sans-serif font exceeds by much, because the font of the reader is not known. {@link
 * org.mechservice.view.drawing.FreePlaces} finds places for texts where they cover nothing.
 *
 * <p>Diagrams and drawings of mechanisms share the package; it knows nothing of either.
 */
@NullMarked
package org.mechservice.view.drawing;

import org.jspecify.annotations.NullMarked;
