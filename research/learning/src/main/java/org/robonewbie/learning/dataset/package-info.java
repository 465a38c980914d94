/**
 * Data sets: sensor readings, commands and true states of many runs, as tables for other programs. Read {@link
 * org.robonewbie.learning.dataset.DataSet} first, then docs/datasets.md.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.learning.dataset;
