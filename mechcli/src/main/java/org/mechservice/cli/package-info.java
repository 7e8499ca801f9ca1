/** The mech command line. */
@NullMarked
package org.mechservice.cli;

import org.jspecify.annotations.NullMarked;
