package org.robonewbie.web;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.examples.Agent_BasicStructure;
import org.robonewbie.examples.Agent_BetterSoccer;
import org.robonewbie.examples.Agent_Dance;
import org.robonewbie.examples.Agent_OwnWorldModel;
import org.robonewbie.examples.Agent_Reactive;
import org.robonewbie.examples.Agent_SimpleSoccer;
import org.robonewbie.examples.Agent_SimpleWalkToBall;
import org.robonewbie.examples.Agent_SmoothDance;
import org.robonewbie.examples.Agent_TestLocalFieldView;
import org.robonewbie.examples.Agent_TestPerceptorInput;
import org.robonewbie.examples.Agent_TestSelfLocalisation;

/**
 * The example agents that the page offers: those in which the framework runs the cycle. Examples that call {@code Nao} themselves would
 * have to be suspended in the middle of a call, and examples with threads cannot run in a page.
 */
final class ShippedAgents {

    private static final Map<String, Supplier<Agent>> MAKERS = new LinkedHashMap<>();

    static {
        MAKERS.put("Agent_BetterSoccer", Agent_BetterSoccer::new);
        MAKERS.put("Agent_SimpleSoccer", Agent_SimpleSoccer::new);
        MAKERS.put("Agent_SimpleWalkToBall", Agent_SimpleWalkToBall::new);
        MAKERS.put("Agent_Dance", Agent_Dance::new);
        MAKERS.put("Agent_SmoothDance", Agent_SmoothDance::new);
        MAKERS.put("Agent_BasicStructure", Agent_BasicStructure::new);
        MAKERS.put("Agent_Reactive", Agent_Reactive::new);
        MAKERS.put("Agent_OwnWorldModel", Agent_OwnWorldModel::new);
        MAKERS.put("Agent_TestLocalFieldView", Agent_TestLocalFieldView::new);
        MAKERS.put("Agent_TestPerceptorInput", Agent_TestPerceptorInput::new);
        MAKERS.put("Agent_TestSelfLocalisation", Agent_TestSelfLocalisation::new);
    }

    private ShippedAgents() {}

    /** {@return the class names of the agents, most impressive first} */
    static List<String> names() {
        return List.copyOf(MAKERS.keySet());
    }

    /**
     * Creates an agent.
     *
     * @param name one of {@link #names}
     * @return the agent, not yet connected
     * @throws IllegalArgumentException if there is no such agent
     */
    static Agent make(String name) {
        Supplier<Agent> maker = MAKERS.get(name);
        if (maker == null) {
            throw new IllegalArgumentException(
                    "Unknown agent \"" + name + "\". Choose one of " + String.join(", ", names()) + ".");
        }
        return maker.get();
    }
}
