package org.robonewbie.simulator.script;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.simulator.script.RubyToken.Kind;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Interpreter of one statement; a setting takes effect only if Ruby always executes the statement. */
final class ScriptStatement {

    private static final int LAST_PORT = 65535;
    private static final int MAX_SHOWN = 70;
    private static final Set<String> SETTERS = Set.of("addSoccerVar", "createVariable");
    private static final Set<String> RUNNERS = Set.of("run", "load", "require_relative");
    private static final Set<String> CONDITIONS = Set.of("if", "unless", "while", "until", "rescue");
    private static final Set<String> ASSIGNMENTS =
            Set.of("=", "+=", "-=", "*=", "/=", "%=", "**=", "||=", "&&=", "|=", "&=", "<<=", ">>=");

    private final ScriptReader reader;
    private final Map<String, Object> variables;
    private final Path file;
    private final RubyStatement statement;
    private final List<RubyToken> tokens;
    private final Optional<RubyStatement> ended;

    ScriptStatement(ScriptReader reader, Path file, RubyStatement statement, Optional<RubyStatement> ended) {
        this.reader = reader;
        this.variables = reader.variables();
        this.file = file;
        this.statement = statement;
        this.tokens = statement.tokens();
        this.ended = ended;
    }

    void execute() throws UnreadableFileException {
        if (statement.block().isPresent() || ended.isPresent()) {
            ignore();
        } else if (isAssignment()) {
            assign();
        } else if (isCall(SETTERS)) {
            set();
        } else if (isCall(RUNNERS)) {
            run();
        } else {
            ignore();
        }
    }

    private boolean isAssignment() {
        RubyToken first = tokens.get(0);
        return tokens.size() > 1
                && (first.kind() == Kind.GLOBAL || first.kind() == Kind.WORD)
                && tokens.get(1).kind() == Kind.SIGN
                && ASSIGNMENTS.contains(tokens.get(1).text());
    }

    private boolean isCall(Set<String> names) {
        return tokens.size() > 1
                && tokens.get(0).kind() == Kind.WORD
                && names.contains(tokens.get(0).text())
                && (tokens.get(1).kind() != Kind.SIGN || tokens.get(1).isSign("("));
    }

    private void assign() throws UnreadableFileException {
        String name = tokens.get(0).text();
        String sign = tokens.get(1).text();
        List<RubyToken> right = tokens.subList(2, tokens.size());
        Optional<Object> value;
        if (sign.equals("||=")) {
            value = Optional.ofNullable(variables.get(name))
                    .filter(before -> !before.equals(false))
                    .or(() -> RubyExpression.value(right, variables));
        } else if (sign.equals("=")) {
            value = RubyExpression.value(right, variables);
        } else {
            value = RubyExpression.value(right, variables).flatMap(operand -> changed(sign, operand));
        }
        value.ifPresentOrElse(known -> variables.put(name, known), () -> variables.remove(name));
        if (looksLikeSetting(tokens.get(0))) {
            take(name, value);
        } else {
            nameSettings();
        }
    }

    private Optional<Object> changed(String sign, Object operand) {
        Map<String, Object> both = new HashMap<>(variables);
        both.put("$;", operand);
        RubyToken first = tokens.get(0);
        return RubyExpression.value(
                List.of(
                        first,
                        new RubyToken(Kind.SIGN, sign.substring(0, sign.length() - 1), first.line(), 0, 0),
                        new RubyToken(Kind.GLOBAL, "$;", first.line(), 0, 0)),
                both);
    }

    /** Interprets {@code addSoccerVar NAME, VALUE}, with or without parentheses. */
    private void set() throws UnreadableFileException {
        List<RubyToken> arguments = arguments();
        boolean named = arguments.size() > 2
                && arguments.get(0).kind() == Kind.STRING
                && arguments.get(1).isSign(",");
        if (!named) {
            ignore();
            return;
        }
        String name = arguments.get(0).text();
        if (tokens.get(0).isWord("createVariable")) {
            if (!name.startsWith("Soccer.")) {
                return;
            }
            name = name.substring("Soccer.".length());
        }
        if (SettingAdvice.isParameter(name)) {
            take(name, RubyExpression.value(arguments.subList(2, arguments.size()), variables));
        } else {
            ignore("there is no parameter " + name + "." + SoccerParameter.question(name));
        }
    }

    private List<RubyToken> arguments() {
        boolean inBrackets =
                tokens.get(1).isSign("(") && tokens.get(tokens.size() - 1).isSign(")");
        return inBrackets ? tokens.subList(2, tokens.size() - 1) : tokens.subList(1, tokens.size());
    }

    private void take(String name, Optional<Object> value) throws UnreadableFileException {
        if (!SettingAdvice.isTaken(name)) {
            ignore(SettingAdvice.of(name, value));
        } else if (value.isEmpty()) {
            ignore(
                    isConditional()
                            ? "it depends on a condition that only Ruby can evaluate."
                            : "its value cannot be evaluated. Write a plain number such as 0.9, or true or false.");
        } else {
            check(name, value.get());
            reader.set(name, value.get());
        }
    }

    private boolean isConditional() {
        return tokens.stream()
                .anyMatch(
                        token -> token.isSign("?") || (token.kind() == Kind.WORD && CONDITIONS.contains(token.text())));
    }

    private void check(String name, Object value) throws UnreadableFileException {
        boolean isPort = name.equals(StartScript.AGENT_PORT) || name.equals(StartScript.MONITOR_PORT);
        if (isPort && !(value instanceof Long port && port >= 0 && port <= LAST_PORT)) {
            throw invalid("The script sets " + name + " to " + value + ", which is not a port number.");
        }
        if (name.startsWith("$") && !isPort && !(value instanceof Boolean)) {
            throw invalid("The script sets " + name + " to " + value + ", which is neither true nor false.");
        }
        if (!name.startsWith("$")) {
            try {
                SoccerParameters.league().with(name + "=" + value);
            } catch (IllegalArgumentException wrong) {
                throw invalid(String.valueOf(wrong.getMessage()));
            }
        }
    }

    private void run() throws UnreadableFileException {
        Optional<Object> name = RubyExpression.value(arguments(), variables);
        if (name.isEmpty() || !(name.get() instanceof String script)) {
            ignore("the name of the script cannot be evaluated. Write it in quotation marks.");
            return;
        }
        String ending = tokens.get(0).isWord("require_relative") && !script.endsWith(".rb") ? ".rb" : "";
        Optional<Path> found = reader.find(script + ending, file);
        if (found.isEmpty()) {
            ignore(
                    SettingAdvice.isStandardScript(script)
                            ? "it is a script of rcssserver3d, which is not needed here."
                            : "there is no file " + script + ending + " beside the script or in the folder "
                                    + Path.of("").toAbsolutePath() + ".");
        } else if (reader.isRunning(found.get())) {
            ignore("that script is already running, and would run itself forever.");
        } else {
            try {
                reader.read(found.get());
            } catch (UnreadableFileException wrong) {
                throw invalid(String.valueOf(wrong.getMessage()));
            }
        }
    }

    /** Reports any setting in a statement that Ruby might not execute; other Ruby code is ignored silently. */
    private void ignore() {
        forgetVariables();
        nameSettings();
    }

    private void nameSettings() {
        if (IntStream.range(0, tokens.size()).noneMatch(this::isSetting)) {
            return;
        }
        if (statement.block().isPresent()) {
            RubyToken block = statement.block().get();
            ignore("it is in the \"" + block.text() + "\" of line " + block.line()
                    + ", and only Ruby knows whether that is executed.");
        } else if (ended.isPresent()) {
            ignore("the script ends earlier, at \""
                    + ended.get().tokens().get(0).text() + "\" in line "
                    + ended.get().line() + ".");
        } else {
            ignore(
                    isConditional()
                            ? "it depends on a condition that only Ruby can evaluate."
                            : "it is not a plain setting. Write " + SettingAdvice.example(tokens) + ".");
        }
    }

    private void ignore(String reason) {
        reader.report(place() + "\"" + shown() + "\" is ignored: " + reason);
    }

    private boolean isSetting(int index) {
        boolean isMethod = index > 0
                && (tokens.get(index - 1).isSign(".") || tokens.get(index - 1).isWord("def"));
        if (isMethod || index + 1 == tokens.size()) {
            return false;
        }
        RubyToken token = tokens.get(index);
        RubyToken next = tokens.get(index + 1);
        if (token.isWord("addSoccerVar") || token.isWord("run")) {
            return next.isSign("(") || next.kind() == Kind.STRING || next.kind() == Kind.OTHER_STRING;
        }
        boolean isAssigned = next.kind() == Kind.SIGN && ASSIGNMENTS.contains(next.text());
        return isAssigned ? looksLikeSetting(token) : token.isWord("Soccer") && next.isSign(".");
    }

    private static boolean looksLikeSetting(RubyToken token) {
        return switch (token.kind()) {
            case GLOBAL -> token.text().matches("\\$\\w+");
            case WORD ->
                Character.isUpperCase(token.text().charAt(0)) || SettingAdvice.isParameterInOtherLetters(token.text());
            default -> false;
        };
    }

    /** Discards the values of variables assigned in a statement that Ruby might not execute. */
    private void forgetVariables() {
        for (int i = 0; i + 1 < tokens.size(); i++) {
            if (tokens.get(i + 1).kind() == Kind.SIGN
                    && ASSIGNMENTS.contains(tokens.get(i + 1).text())) {
                variables.remove(tokens.get(i).text());
            }
        }
    }

    private String shown() {
        StringBuilder text = new StringBuilder();
        int end = tokens.get(0).from();
        for (RubyToken token : tokens) {
            text.append(token.from() > end ? " " : "").append(SettingAdvice.quoted(token));
            end = token.to();
        }
        return text.length() <= MAX_SHOWN ? text.toString() : text.substring(0, MAX_SHOWN) + "…";
    }

    private UnreadableFileException invalid(String problem) {
        return UnreadableFileException.atLine(file, statement.line(), problem);
    }

    private String place() {
        return file + ", line " + statement.line() + ": ";
    }
}
