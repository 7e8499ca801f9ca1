/**
 * From elements to a mechanism in SI: names become references, expressions numbers, joints a tree.
 *
 * <p>One class reads one kind of element; {@link org.mechservice.mechml.resolve.ModelResolver} says
 * in which order. A reader that cannot make sense of its element says so and returns nothing, so
 * that one reading finds all independent errors.
 */
@NullMarked
package org.mechservice.mechml.resolve;

import org.jspecify.annotations.NullMarked;
