/**
 * A study from its file to its table.
 *
 * <p>{@link org.mechservice.study.run.StudyReader} reads the file and checks every name in it
 * against the model. {@link org.mechservice.study.run.Study} runs the points in chunks, several at
 * a time, and takes their rows in the order of the points: each is a line of the journal as soon as
 * all before it are. The journal is therefore always the beginning of the table, and what ends the
 * process at any time costs the rows under way, nothing else. A stop rule sees the rows in the same
 * order, so that the table does not depend on how many ran at once.
 *
 * <p>{@link org.mechservice.study.run.StudyJoin} puts parts together to the table that the whole
 * study would have written, byte by byte.
 */
@NullMarked
package org.mechservice.study.run;

import org.jspecify.annotations.NullMarked;
