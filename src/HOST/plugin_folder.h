/* SPH-TM: where the plugin was loaded from. */
#ifndef SPHTM_PLUGIN_FOLDER_H
#define SPHTM_PLUGIN_FOLDER_H

#include <string>

namespace SPHTM_NS {

// the folder of sphtm_styles.so, links resolved; what is installed with it is found from there
const std::string &plugin_folder();

}    // namespace SPHTM_NS

#endif
