package org.robonewbie.simulator.server;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** The simplest agent: says what it is told to and reads each answer. */
final class TestAgent implements AutoCloseable {

    private static final int CYCLES_UNTIL_REFUSED = 60;

    private final AgentLink link;
    private final MessageBuffer message = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    TestAgent(AgentLink link) {
        this.link = link;
    }

    /** Creates a robot, joins a team as the original client does, and returns the message with the number. */
    PerceptorMessage join(String team, int number) throws IOException {
        return join("rsg/agent/nao/nao.rsg", team, number);
    }

    /** Creates a certain robot and joins a team. */
    PerceptorMessage join(String scene, String team, int number) throws IOException {
        send("(scene " + scene + ")(syn)");
        receive();
        send("(init (unum " + number + ")(teamname " + team + "))(syn)");
        receive();
        send("(syn)");
        return receive();
    }

    /** Joins a game that does not wait for its agents; returns the first message with the number. */
    PerceptorMessage joinRunningGame(String team, int number) throws IOException {
        PerceptorMessage answer = sendInit(team, number);
        while (answer.gameState().orElseThrow().number().isEmpty()) {
            answer = receive();
        }
        return answer;
    }

    /** Sends an init message that the simulator refuses; returns the message of some cycles later. */
    PerceptorMessage joinInVain(String team, int number) throws IOException {
        PerceptorMessage answer = sendInit(team, number);
        for (int i = 0; i < CYCLES_UNTIL_REFUSED; i++) {
            answer = receive();
        }
        return answer;
    }

    private PerceptorMessage sendInit(String team, int number) throws IOException {
        exchange("(scene rsg/agent/nao/nao.rsg)");
        return exchange("(init (unum " + number + ")(teamname " + team + "))");
    }

    void send(String text) throws IOException {
        message.clear();
        message.append(text);
        link.send(message);
    }

    PerceptorMessage receive() throws IOException {
        return reader.read(receiveText());
    }

    MessageBuffer receiveText() throws IOException {
        if (!link.receive(message)) {
            throw new IOException("The simulator has ended.");
        }
        return message;
    }

    PerceptorMessage exchange(String text) throws IOException {
        send(text);
        return receive();
    }

    @Override
    public void close() throws IOException {
        link.close();
    }
}
