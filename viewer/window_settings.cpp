#include "viewer/window_settings.h"

namespace relievo::viewer {

WindowSettings makeWindowSettings(const ViewOptions& options) {
    WindowSettings settings;
    settings.options = options;
    settings.techniqueA = options.techniques.at(0);
    settings.techniqueB = kReferenceName;
    if (options.techniques.size() > 1) {
        settings.techniqueB = options.techniques[1];
        settings.mode = ComparisonMode::SideBySide;
    }
    return settings;
}

std::vector<std::string_view> techniqueChoices() {
    std::vector<std::string_view> names;
    for (const materials::Technique& technique : materials::techniques())
        names.push_back(technique.name);
    names.push_back(kReferenceName);
    return names;
}

std::string_view techniqueTitle(std::string_view name) {
    return name == kReferenceName ? materials::givenHitsTechnique().title
                                  : materials::findTechnique(name).title;
}

bool showsSecond(const WindowSettings& settings) {
    return settings.mode == ComparisonMode::SideBySide || settings.mode == ComparisonMode::Split;
}

bool needsReference(const WindowSettings& settings) {
    return settings.measureErrors || settings.mode == ComparisonMode::HeatMap ||
           settings.techniqueA == kReferenceName ||
           (showsSecond(settings) && settings.techniqueB == kReferenceName);
}

double parameterValue(const ViewOptions& options, std::string_view technique,
                      const materials::TechniqueParameter& parameter) {
    double value = parameter.defaultValue;
    for (const ParameterSetting& setting : options.parameters)
        if (setting.name == parameter.name &&
            (setting.technique.empty() || setting.technique == technique))
            value = setting.value;
    return value;
}

void setParameterValue(ViewOptions& options, std::string_view technique,
                       const materials::TechniqueParameter& parameter, double value) {
    std::erase_if(options.parameters, [&](const ParameterSetting& setting) {
        return setting.technique == technique && setting.name == parameter.name;
    });
    options.parameters.push_back({std::string(technique), std::string(parameter.name), value});
}

}  // namespace relievo::viewer
