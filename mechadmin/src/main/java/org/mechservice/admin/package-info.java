/** What an operator sees and does, on the terminal. */
@NullMarked
package org.mechservice.admin;

import org.jspecify.annotations.NullMarked;
