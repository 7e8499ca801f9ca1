/**
 * Pictures of results and mechanisms: curves, drawings, the player. The command line and the web
 * client stand on the same pieces.
 */
@NullMarked
package org.mechservice.view;

import org.jspecify.annotations.NullMarked;
