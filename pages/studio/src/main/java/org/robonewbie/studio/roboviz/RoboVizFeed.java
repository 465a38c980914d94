package org.robonewbie.studio.roboviz;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What teams have drawn for RoboViz: sets of shapes with two buffers each. Shapes go to the hidden one and appear at the next swap
 * of their set, which empties the new hidden one, so that a swap without shapes erases. May be used by any thread.
 */
public final class RoboVizFeed {

    /** The set of the texts above robots, which need no swap. */
    static final String AGENT_TEXTS = "texts above robots";

    private static final int MOST_SETS = 300;
    private static final int MOST_SHAPES = 2000;

    private final Map<String, List<RoboVizCommand.Draw>> hidden = new LinkedHashMap<>();
    private final Map<String, Sheet> shown = new TreeMap<>();
    private final Map<String, RoboVizCommand.AgentText> agentTexts = new TreeMap<>();
    private int revision;

    /** What is to be seen of a set, and since which revision of the board. */
    private record Sheet(int revision, JsonArray shapes) {}

    /** Creates an empty board. */
    public RoboVizFeed() {}

    synchronized void obey(Collection<RoboVizCommand> commands) {
        commands.forEach(this::obey);
    }

    private void obey(RoboVizCommand command) {
        if (command instanceof RoboVizCommand.Draw draw) {
            draw(draw);
        } else if (command instanceof RoboVizCommand.Swap swap) {
            swap(swap.prefix());
        } else if (command instanceof RoboVizCommand.AgentText text) {
            write(text);
        }
    }

    private void draw(RoboVizCommand.Draw draw) {
        List<RoboVizCommand.Draw> shapes = hidden.get(draw.set());
        if (shapes == null && hidden.size() < MOST_SETS) {
            shapes = new ArrayList<>();
            hidden.put(draw.set(), shapes);
        }
        if (shapes != null && shapes.size() < MOST_SHAPES) {
            shapes.add(draw);
        }
    }

    private void swap(String prefix) {
        revision++;
        hidden.forEach((set, shapes) -> {
            if (set.startsWith(prefix)) {
                JsonArray sheet = new JsonArray();
                shapes.forEach(shape -> sheet.add(json(shape)));
                shown.put(set, new Sheet(revision, sheet));
                shapes.clear();
            }
        });
    }

    private void write(RoboVizCommand.AgentText text) {
        revision++;
        String robot = text.side() + " " + text.number();
        if (text.text().isEmpty()) {
            agentTexts.remove(robot);
        } else {
            agentTexts.put(robot, text);
        }
        JsonArray sheet = new JsonArray();
        agentTexts.values().forEach(each -> sheet.add(json(each)));
        shown.put(AGENT_TEXTS, new Sheet(revision, sheet));
    }

    private static JsonObject json(RoboVizCommand.Draw draw) {
        JsonObject json = new JsonObject();
        json.addProperty("shape", draw.shape());
        JsonArray numbers = new JsonArray();
        draw.numbers().forEach(numbers::add);
        json.add("numbers", numbers);
        json.addProperty("colour", draw.colour());
        json.addProperty("opacity", draw.opacity());
        json.addProperty("text", draw.text());
        return json;
    }

    private static JsonObject json(RoboVizCommand.AgentText text) {
        JsonObject json = new JsonObject();
        json.addProperty("shape", "agent");
        json.addProperty("side", text.side().name().toLowerCase(Locale.ROOT));
        json.addProperty("number", text.number());
        json.addProperty("colour", text.colour());
        json.addProperty("text", text.text());
        return json;
    }

    /** {@return how often the board has changed} */
    public synchronized int revision() {
        return revision;
    }

    /**
     * Writes the sets that have changed.
     *
     * @param known the revision that a page knows, 0 for none
     * @return one JSON object for the page; empty if there is nothing new
     */
    public synchronized Optional<String> since(int known) {
        JsonObject sets = new JsonObject();
        shown.forEach((set, sheet) -> {
            if (sheet.revision() > known) {
                sets.add(set, sheet.shapes());
            }
        });
        if (sets.isEmpty()) {
            return Optional.empty();
        }
        JsonObject json = new JsonObject();
        json.addProperty("kind", "board");
        json.add("sets", sets);
        return Optional.of(json.toString());
    }
}
