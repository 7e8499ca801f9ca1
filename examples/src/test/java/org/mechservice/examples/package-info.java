/**
 * Tests that do what a user does: start {@code ./mech}, read the files it writes and what it says.
 * None of them calls a class of the product.
 */
@NullMarked
package org.mechservice.examples;

import org.jspecify.annotations.NullMarked;
