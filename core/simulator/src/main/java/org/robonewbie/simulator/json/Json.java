package org.robonewbie.simulator.json;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.Collection;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Builds JSON without reflection, which the web edition lacks. Values are strings, numbers, booleans, JSON elements,
 * collections of values, and maps from strings to values.
 *
 * <pre>{@code
 * Json.object("name", "Corner", "score", List.of(1, 0)) // {"name":"Corner","score":[1,0]}
 * }</pre>
 */
public final class Json {

    private Json() {}

    /**
     * Creates an object.
     *
     * @param members alternating names and values
     * @return the object
     * @throws ClassCastException if a value cannot be converted
     */
    public static JsonObject object(Object... members) {
        JsonObject json = new JsonObject();
        for (int i = 0; i < members.length; i += 2) {
            json.add((String) members[i], element(members[i + 1]));
        }
        return json;
    }

    /**
     * Creates an array.
     *
     * @param values the elements
     * @return the array
     * @throws ClassCastException if a value cannot be converted
     */
    public static JsonArray array(Stream<?> values) {
        JsonArray json = new JsonArray();
        values.map(Json::element).forEach(json::add);
        return json;
    }

    private static JsonElement element(Object value) {
        if (value instanceof JsonElement json) {
            return json;
        }
        if (value instanceof Collection<?> values) {
            return array(values.stream());
        }
        if (value instanceof Map<?, ?> members) {
            JsonObject json = new JsonObject();
            members.forEach((name, member) -> json.add((String) name, element(member)));
            return json;
        }
        if (value instanceof Number number) {
            return new JsonPrimitive(number);
        }
        return value instanceof Boolean truth ? new JsonPrimitive(truth) : new JsonPrimitive((String) value);
    }
}
