package org.robonewbie.studio;

import java.util.List;
import java.util.function.UnaryOperator;
import org.robonewbie.studio.service.PageService;

/** A course of two exercises without attempts. */
final class SmallCourse implements PageService {

    private static final String NO_ATTEMPT = "{\"state\":\"NONE\",\"judged\":[],\"output\":\"\"}";
    private static final String OVERVIEW = """
            {"language":"en","programs":["Other.java"],"acceptsAgents":true,
            "standings":{"sum":"1 of 2 exercises passed, 8.5 of 20 points, 7 min","badges":["First success"],"csv":"name"},
            "lessons":[
            {"number":1,"name":"arms","title":"Raise arms","goal":"Raise both.","level":"first steps","minutes":15,"points":10,
            "worksheet":"docs/a.html","file":"Arms.java","standing":{"tries":2,"best":8.5,"passed":true,"minutes":7}},
            {"number":2,"name":"kick","title":"A kick","goal":"Kick it.","level":"challenge","minutes":120,"points":10,
            "worksheet":"docs/exercises/k.html","file":"Kick.java",
            "standing":{"tries":0,"best":0,"passed":false,"minutes":0}}]}
            """;

    @Override
    public String answer(String method, List<String> path, UnaryOperator<String> parameters) {
        return path.isEmpty() ? OVERVIEW : NO_ATTEMPT;
    }
}
