/** The console as a page in a browser of this machine. */
@NullMarked
package org.mechservice.admin.web;

import org.jspecify.annotations.NullMarked;
