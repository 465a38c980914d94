package org.robonewbie.exercises.service;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.FirstMinute;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.progress.Progress;

/** Writes the levels of the {@link FirstMinute}, with the words that the page shows around them. */
record FirstMinuteWriter(Language language, Progress progress) {

    JsonObject json() {
        JsonArray levels = new JsonArray();
        FirstMinute.levels().forEach(level -> levels.add(level(level)));
        JsonObject json = new JsonObject();
        json.add("levels", levels);
        json.add("words", words());
        return json;
    }

    private JsonObject level(Exercise level) {
        JsonObject json = new JsonObject();
        json.addProperty("name", level.name());
        json.addProperty("title", language.translated(level.title()));
        json.addProperty("goal", language.translated(level.goal()));
        json.addProperty("file", CourseService.file(level));
        json.addProperty("passed", progress.of(level).passed());
        json.addProperty("start", level.startCode());
        json.addProperty("solution", FirstMinute.solution(level));
        return json;
    }

    private JsonObject words() {
        JsonObject words = new JsonObject();
        words.addProperty("level", language.translated("Level"));
        words.addProperty("edit", language.translated("Type it, or press Tab:"));
        words.addProperty("run", language.translated("Press ▶ Run (Ctrl+Enter)."));
        words.addProperty("watch", language.translated("Watch the robot …"));
        words.addProperty("passed", language.translated("Well done:"));
        words.addProperty("failed", language.translated("Not yet:"));
        words.addProperty("broken", language.translated("Fix the line marked in red first."));
        words.addProperty("next", language.translated("Next level"));
        words.addProperty("finish", language.translated("Go on with exercise 1"));
        words.addProperty("skip", language.translated("Skip"));
        words.addProperty("skipHint", language.translated("Hides these three levels permanently"));
        return words;
    }
}
