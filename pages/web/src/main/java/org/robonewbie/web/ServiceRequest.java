package org.robonewbie.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.robonewbie.studio.service.PageService;

/**
 * A request from the page's scripts to a service.
 *
 * @param json method, path and parameters of the request, and the browser's stored data
 */
record ServiceRequest(JsonObject json) {

    static ServiceRequest parse(String text) {
        return new ServiceRequest(JsonParser.parseString(text).getAsJsonObject());
    }

    /** An action that may be rejected. */
    interface Action {
        String run() throws IOException;
    }

    /** Returns the result of an action, or a sentence if it is rejected. */
    static String attempt(Action action) {
        try {
            return action.run();
        } catch (IllegalArgumentException | IllegalStateException | IOException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /** Passes this request to a service; returns JSON, or a sentence if the request is rejected. */
    String answer(PageService service) {
        JsonObject parameters = json.getAsJsonObject("parameters");
        return attempt(() -> service.answer(
                json.get("method").getAsString(),
                texts("path"),
                name -> parameters.has(name) ? parameters.get(name).getAsString() : ""));
    }

    /** Returns the strings in a JSON array. */
    List<String> texts(String name) {
        return elements(name).map(JsonElement::getAsString).toList();
    }

    /** Returns the elements of a JSON array. */
    Stream<JsonElement> elements(String name) {
        return StreamSupport.stream(json.getAsJsonArray(name).spliterator(), false);
    }
}
