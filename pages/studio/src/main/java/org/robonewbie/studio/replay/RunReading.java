package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import java.util.List;

/**
 * The part of a recording that has been read.
 *
 * @param summary summary as described in {@link RunWatch#summary}; must not be changed
 * @param whole whether the whole recording has been read
 * @param pieces index of the first cycle of each piece that a page can load separately
 */
public record RunReading(JsonObject summary, boolean whole, List<Integer> pieces) {}
